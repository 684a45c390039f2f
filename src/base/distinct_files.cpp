#include "base/distinct_files.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <filesystem>

#include "base/error.h"
#include "base/link_end.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

// Gives all paths to a file the same spelling, except those by hard links. The file need not exist.
std::string canonicalPath(const std::string& path) {
    std::error_code failure;
    const fs::path end = fs::absolute(endOfLinks(path, failure), failure);
    const fs::path folder = fs::weakly_canonical(end.parent_path(), failure);
    return ((failure ? end.parent_path() : folder) / end.filename()).string();
}

}  // namespace

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored) || canonicalPath(a) == canonicalPath(b);
}

void DistinctFiles::add(const File& file, const std::string& path) {
    struct stat status = {};
    const bool exists = stat(path.c_str(), &status) == 0;
    if (exists && S_ISCHR(status.st_mode)) return;
    const auto keepApart = [&](const File& other) {
        if (file.isRead && other.isRead) return;
        const File& written = file.isRead ? other : file;
        const File& second = file.isRead ? file : other;
        throw Error(fmt::format("{}: this is the same file as {}, which is {}; give it another name", written.name,
                                second.name, second.isRead ? "read" : "written too"));
    };
    const auto [byPath, isNewPath] = byPath_.emplace(canonicalPath(path), file);
    if (!isNewPath) keepApart(byPath->second);
    if (!exists) return;
    const auto [byInode, isNewInode] = byInode_.emplace(Inode{status.st_dev, status.st_ino}, file);
    if (!isNewInode) keepApart(byInode->second);
}

}  // namespace drc
