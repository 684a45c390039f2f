// Tells whether a file has changed, without reading it.
#pragma once
#include <compare>
#include <cstdint>
#include <string>

namespace drc {

// A file by its path, its size and the time of its last change; both are 0 for a file that is not there.
struct FileStamp {
    explicit FileStamp(const std::string& path);
    std::string path;
    uint64_t size = 0;
    int64_t time = 0;
    auto operator<=>(const FileStamp&) const = default;
};

}  // namespace drc
