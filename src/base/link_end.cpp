#include "base/link_end.h"

#include <sys/stat.h>

#include <filesystem>

#include "base/stream_file.h"

namespace drc {

// Follows links itself, because std::filesystem::weakly_canonical stops before a link whose target does not exist yet.
std::string endOfLinks(const std::string& path, std::error_code& failure) {
    namespace fs = std::filesystem;
    constexpr int kMostLinks = 40;  // the system's limit
    failure.clear();
    std::string end = path;
    for (int links = 0; ownDescriptor(end) < 0; ++links) {
        struct stat status = {};
        if (lstat(end.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) break;
        if (stat(end.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) break;
        if (links == kMostLinks) {
            failure = std::make_error_code(std::errc::too_many_symbolic_link_levels);
            break;
        }
        const fs::path link(end), next = fs::read_symlink(link, failure);
        if (failure) break;
        end = (link.parent_path() / next).string();  // an absolute target replaces the parent path
    }
    return end;
}

}  // namespace drc
