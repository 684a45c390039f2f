#include "render/frame_list.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "base/error.h"
#include "render/picture_writer.h"

namespace drc {
namespace {

// Calls f, and puts the place before the message of an Error that it throws.
template <typename F>
void placedIn(const std::string& place, const F& f) {
    try {
        f();
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", place, error.what()));
    }
}

// The UTF-8 byte order mark, which editors on Windows write.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

FrameList::FrameList(const std::string& path)
    : name_(path == "-" ? "standard input" : path), in_(path == "-" ? std::cin : file_) {
    if (path == "-") return;
    file_.open(path);
    if (!file_) throw Error(fmt::format("--frames: cannot read {}", path));
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw Error(fmt::format("--frames: {} is a folder", path));
    // The next line of a pipe may be written only after the frame before it has been finished.
    isWhole_ = std::filesystem::is_regular_file(path, ignored);
    if (!isWhole_) return;
    while (std::optional<FrameFiles> frame = read()) frames_.push_back(std::move(*frame));
}

std::optional<FrameFiles> FrameList::next() {
    if (!isWhole_) return read();
    if (frames_.empty()) return {};
    FrameFiles frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
}

std::optional<FrameFiles> FrameList::read() {
    for (std::string text; std::getline(in_, text);) {
        if (++line_ == 1 && text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
        if (!text.empty() && text.back() == '\r') text.pop_back();
        const size_t begin = text.find_first_not_of(" \t");
        if (begin == std::string::npos || text[begin] == '#') continue;
        std::vector<std::string> parts;
        for (size_t at = 0; at <= text.size();) {
            const size_t end = std::min(text.find('\t', at), text.size());
            parts.push_back(text.substr(at, end - at));
            at = end + 1;
        }
        if (parts.size() < 2 || std::ranges::count(parts, "") > 0)
            throw Error(fmt::format("{}:{}: expected a scene file and, after a tab, the picture to write, found '{}'",
                                    name_, line_, text));
        FrameFiles frame{parts[0], {parts.begin() + 1, parts.end()}};
        check(frame);
        return frame;
    }
    return {};
}

void FrameList::check(const FrameFiles& frame) {
    const std::string place = fmt::format("{}:{}", name_, line_);
    std::error_code error;
    const auto status = std::filesystem::status(frame.scene, error);
    if (!std::filesystem::exists(status))
        throw Error(fmt::format("{}: there is no scene file '{}'", place, frame.scene));
    if (std::filesystem::is_directory(status))
        throw Error(fmt::format("{}: '{}' is a folder, not a scene file", place, frame.scene));
    if (::access(frame.scene.c_str(), R_OK) != 0)
        throw Error(fmt::format("{}: cannot read '{}': {}", place, frame.scene, std::strerror(errno)));
    for (const std::string& path : frame.outputs) {
        placedIn(place, [&] {
            outputKind(path);
            checkOutput("-o", path);
        });
        const auto [entry, isNew] =
            lineOfOutput_.try_emplace(std::filesystem::absolute(path).lexically_normal().string(), line_);
        if (!isNew) throw Error(fmt::format("{}: the picture {} is that of line {}, too", place, path, entry->second));
    }
}

void FrameList::finished(const std::vector<std::string>& outputs) {
    fmt::print("{}\n", fmt::join(outputs, "\t"));
    std::fflush(stdout);
}

}  // namespace drc
