#include "base/file_stamp.h"

#include <filesystem>

namespace drc {

FileStamp::FileStamp(const std::string& of) : path(of) {
    std::error_code failed;
    const auto bytes = std::filesystem::file_size(of, failed);
    if (!failed) size = bytes;
    const auto changed = std::filesystem::last_write_time(of, failed);
    if (!failed) time = changed.time_since_epoch().count();
}

}  // namespace drc
