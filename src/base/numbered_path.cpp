#include "base/numbered_path.h"

#include <fmt/core.h>

#include <filesystem>

namespace drc {

std::string numberedPath(const std::string& folder, const std::string& path, const std::string& word, int number) {
    namespace fs = std::filesystem;
    constexpr size_t kLongestName = 255;  // bytes; the limit of nearly all file systems
    const fs::path name = fs::path(path).filename();
    const std::string end =
        fmt::format(".{}{}{}", word, number > 1 ? fmt::format("-{}", number) : "", name.extension().string());
    std::string stem = name.stem().string();
    if (stem.size() + end.size() > kLongestName) {
        size_t length = kLongestName - end.size();
        // Do not cut inside a UTF-8 character.
        while (length > 0 && (static_cast<unsigned char>(stem[length]) & 0xc0) == 0x80) --length;
        stem.resize(length);
    }
    return (fs::path(folder) / (stem + end)).string();
}

}  // namespace drc
