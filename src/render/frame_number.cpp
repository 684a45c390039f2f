#include "render/frame_number.h"

#include <fmt/core.h>

#include <charconv>
#include <filesystem>

#include "base/log.h"

namespace drc {

std::optional<int> frameNumberOf(const std::string& scene) {
    constexpr size_t kMostDigits = 9;
    std::filesystem::path path = std::filesystem::path(scene).filename();
    if (path.extension() == ".gz") path = path.stem();
    const std::string stem = path.stem().string();
    const size_t last = stem.find_last_not_of("0123456789");
    const size_t begin = last == std::string::npos ? 0 : last + 1, digits = stem.size() - begin;
    if (digits == 0 || digits > kMostDigits) return {};
    int number = 0;
    std::from_chars(stem.data() + begin, stem.data() + stem.size(), number);
    return number;
}

void FrameNumbers::add(const std::string& scene) {
    const std::optional<int> number = frameNumberOf(scene);
    const auto [known, isNew] = sceneOf_.try_emplace(number, scene);
    if (isNew || hasWarned_) return;
    hasWarned_ = true;
    logWarning(
        fmt::format("--frames: {} and {} have {}, so that their noise is the same and sticks to the screen; "
                    "number the scene files, as frame1.pbrt and frame2.pbrt",
                    known->second, scene,
                    number ? fmt::format("the same number {} at the end of their names", *number)
                           : "no number at the end of their names"));
}

}  // namespace drc
