#include "base/frame_pattern.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/error.h"

namespace drc {
namespace {

constexpr size_t kMostFrames = 1000000;

[[noreturn]] void failList(const std::string& option, const std::string& list, const std::string& why) {
    throw Error(fmt::format("{} {}: {}; a list of frames is such as 1-24 or 1,3,8-12", option, list, why));
}

int numberIn(std::string_view text, const std::string& option, const std::string& list) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc() || end != text.data() + text.size() || number < 0)
        failList(option, list, fmt::format("'{}' is not the number of a frame", text));
    return number;
}

}  // namespace

FramePattern::FramePattern(const std::string& option, const std::string& pattern) {
    const size_t folder = pattern.rfind('/'), name = folder == std::string::npos ? 0 : folder + 1;
    const size_t first = pattern.find('#', name), last = pattern.rfind('#');
    if (first == std::string::npos || pattern.find_first_not_of('#', first) < last)
        throw Error(
            fmt::format("{} {}: with --frames, the name of the file must have a run of # in place of the frame's "
                        "number, such as f_####.exr",
                        option, pattern));
    before_ = pattern.substr(0, first);
    after_ = pattern.substr(last + 1);
    digits_ = last + 1 - first;
}

std::string FramePattern::path(int number) const { return fmt::format("{}{:0{}}{}", before_, number, digits_, after_); }

std::vector<int> frameNumbers(const std::string& option, const std::string& list) {
    std::vector<int> numbers;
    for (size_t begin = 0; begin <= list.size();) {
        const size_t end = std::min(list.find(',', begin), list.size());
        const std::string_view item = std::string_view(list).substr(begin, end - begin);
        const size_t dash = item.find('-');
        const int first = numberIn(item.substr(0, dash), option, list);
        const int last = dash == std::string_view::npos ? first : numberIn(item.substr(dash + 1), option, list);
        if (last < first) failList(option, list, fmt::format("{} comes before {}", last, first));
        if (numbers.size() + size_t(last - first) >= kMostFrames) failList(option, list, "there are too many frames");
        for (int number = first; number <= last; ++number) numbers.push_back(number);
        begin = end + 1;
    }
    std::ranges::sort(numbers);
    if (const auto twice = std::ranges::adjacent_find(numbers); twice != numbers.end())
        failList(option, list, fmt::format("it has frame {} twice", *twice));
    return numbers;
}

}  // namespace drc
