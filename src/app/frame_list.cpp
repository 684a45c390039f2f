#include "app/frame_list.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <iostream>

#include "app/picture_writer.h"
#include "base/error.h"

namespace drc {

FrameList::FrameList(const std::string& path)
    : name_(path == "-" ? "standard input" : path), in_(path == "-" ? std::cin : file_) {
    if (path == "-") return;
    file_.open(path);
    if (!file_) throw Error(fmt::format("--frames: cannot read {}", path));
}

std::optional<FrameList::Frame> FrameList::next() {
    for (std::string text; std::getline(in_, text);) {
        ++line_;
        if (!text.empty() && text.back() == '\r') text.pop_back();
        if (text.empty()) continue;
        std::vector<std::string> parts;
        for (size_t at = 0; at <= text.size();) {
            const size_t end = std::min(text.find('\t', at), text.size());
            parts.push_back(text.substr(at, end - at));
            at = end + 1;
        }
        const std::string place = fmt::format("{}:{}", name_, line_);
        if (parts.size() < 2 || std::ranges::count(parts, "") > 0)
            throw Error(fmt::format("{}: expected a scene file and, after a tab, the picture to write, found '{}'",
                                    place, text));
        Frame frame{parts[0], {parts.begin() + 1, parts.end()}};
        for (const std::string& path : frame.outputs) {
            outputKind(path);
            checkOutput(place + ":", path);
        }
        return frame;
    }
    return {};
}

void FrameList::finished(const std::vector<std::string>& outputs) {
    fmt::print("{}\n", fmt::join(outputs, "\t"));
    std::fflush(stdout);
}

}  // namespace drc
