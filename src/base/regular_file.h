// Whether a path is that of a regular file, which can be read again, and replaced: no pipe, folder or device.
#pragma once
#include <filesystem>
#include <string>
#include <system_error>

namespace drc {

// False also where it cannot be told.
inline bool isRegularFile(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace drc
