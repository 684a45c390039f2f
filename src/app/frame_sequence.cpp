#include "app/frame_sequence.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.h"
#include "base/log.h"

namespace drc {

FrameSequence::FrameSequence(RenderOptions& options) : options_(options) {
    if (!options.frames.empty()) list_.emplace(options.frames);
    claimPictures();
}

void FrameSequence::claimPictures() {
    if (options_.frames == "-") return;
    for (const std::string& path : options_.outputs)
        pictures_.writes(list_ ? fmt::format("frame {}'s picture", number_) : "-o", path);
}

void FrameSequence::finished() const {
    if (list_) FrameList::finished(options_.outputs);
}

bool FrameSequence::next() {
    std::optional<FrameList::Frame> frame;
    if (list_) frame = list_->next();
    if (!frame) return false;
    ++number_;
    options_.scene = frame->scene;
    options_.outputs = frame->outputs;
    claimPictures();
    return true;
}

void FrameSequence::skipTo(int number) {
    while (number_ < number) {
        for (const std::string& path : options_.outputs)
            if (std::error_code ignored; !std::filesystem::exists(path, ignored))
                logWarning(fmt::format("{}: frame {} was rendered before the checkpoint was saved, but is not there",
                                       path, number_));
        if (!options_.outputs.empty()) finished();  // those that the film names are not known
        if (!next())
            throw Error(fmt::format("--resume {}: it is in frame {}, and {} ends after frame {}", options_.resume,
                                    number, options_.frames, number_));
    }
}

}  // namespace drc
