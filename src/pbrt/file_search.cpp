#include "pbrt/file_search.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace drc::pbrt {
namespace fs = std::filesystem;

std::string FileSearch::find(const std::string& name, const SourcePos& pos, const std::string& what) const {
    if (name.empty()) fail(pos, "the name of the " + what + " is empty");
    if (name.find('\0') != std::string::npos) fail(pos, "the name of the " + what + " has a zero byte in it");
    std::vector<fs::path> seen;
    std::string tried;
    // Whether the path is a file to read. Scenes name thousands of files, so paths are built and tested only when
    // needed.
    const auto isFile = [&](const fs::path& path) {
        if (!seen.empty() && seen.back() == path) return false;
        seen.push_back(path);
        std::error_code ignored;
        const fs::file_status status = fs::status(path, ignored);
        if (fs::is_regular_file(status)) return true;
        tried += (tried.empty() ? "" : " and ") + ("'" + path.string() + "'");
        // Pipes and devices may have no end, or may block when opened.
        if (fs::exists(status)) tried += fs::is_directory(status) ? ", a folder" : ", which is no file but a device";
        return false;
    };
    const auto isFound = [&](const std::string& spelt) {
        if (fs::path(spelt).is_absolute()) return isFile(spelt);
        if (pos.source != nullptr && isFile(fs::path(pos.source->directory()) / spelt)) return true;
        if (isFile(fs::path(mainDirectory_) / spelt)) return true;
        // If the naming file was reached by a symbolic link, also search beside the file that the link points to.
        std::error_code ignored;
        return pos.source != nullptr && fs::is_symlink(pos.source->name(), ignored) &&
               isFile(fs::weakly_canonical(pos.source->name(), ignored).parent_path() / spelt);
    };
    if (isFound(name)) return note(seen.back().string());
    // Exporters on Windows write folders with backslashes. Under Linux a backslash may be part of a name, which was
    // tried first.
    std::string withSlashes = name;
    std::ranges::replace(withSlashes, '\\', '/');
    if (withSlashes != name && isFound(withSlashes)) return note(seen.back().string());
    fail(pos, "cannot find the " + what + " '" + name + "'; tried " + tried);
}

std::string FileSearch::note(const std::string& path) const {
    const std::lock_guard lock(found_->mutex);
    if (found_->known.insert(path).second) found_->paths.push_back(path);
    return path;
}

std::vector<std::string> FileSearch::found() const {
    const std::lock_guard lock(found_->mutex);
    return found_->paths;
}

}  // namespace drc::pbrt
