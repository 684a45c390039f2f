#include "render/frame_sequence.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.h"
#include "base/log.h"

namespace drc {

FrameSequence::FrameSequence(FrameFiles& present, const std::string& list) : present_(present), listName_(list) {
    if (!list.empty()) list_.emplace(list);
    begin();
}

void FrameSequence::begin() {
    numbers_.add(present_.scene);
    if (listName_ == "-") return;
    for (const std::string& path : present_.outputs)
        pictures_.writes(list_ ? fmt::format("frame {}'s picture", number_) : "-o", path);
}

void FrameSequence::finished() const {
    if (list_) FrameList::finished(present_.outputs);
}

bool FrameSequence::next() {
    std::optional<FrameFiles> frame;
    if (list_) frame = list_->next();
    if (!frame) return false;
    ++number_;
    present_ = std::move(*frame);
    begin();
    return true;
}

void FrameSequence::skipTo(int number, const std::string& checkpoint) {
    while (number_ < number) {
        for (const std::string& path : present_.outputs)
            if (std::error_code ignored; !std::filesystem::exists(path, ignored))
                logWarning(fmt::format("{}: frame {} was rendered before the checkpoint was saved, but is not there",
                                       path, number_));
        if (!present_.outputs.empty()) finished();  // the names in the scene's film are not known here
        if (!next())
            throw Error(fmt::format("--resume {}: it is in frame {}, and {} ends after frame {}", checkpoint, number,
                                    listName_, number_));
    }
}

}  // namespace drc
