// Whether a path leads to a regular file, which can be read repeatedly and replaced: not a pipe, folder or device.
#pragma once
#include <filesystem>
#include <string>
#include <system_error>

namespace drc {

// Also false if the system cannot tell.
inline bool isRegularFile(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace drc
