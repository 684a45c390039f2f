#include "pbrt/file_search.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace drc::pbrt {
namespace fs = std::filesystem;

std::string FileSearch::find(const std::string& name, const SourcePos& pos, const std::string& what) const {
    if (name.empty()) fail(pos, "the name of the " + what + " is empty");
    if (name.find('\0') != std::string::npos) fail(pos, "the name of the " + what + " has a zero byte in it");
    std::vector<fs::path> candidates;
    const auto addCandidates = [&](const std::string& spelt) {
        if (fs::path(spelt).is_absolute()) {
            candidates.push_back(spelt);
            return;
        }
        if (pos.source != nullptr) candidates.push_back(fs::path(pos.source->directory()) / spelt);
        candidates.push_back(fs::path(mainDirectory_) / spelt);
        // If the file is reached by a symbolic link, also search beside the file that it points to.
        std::error_code ignored;
        if (pos.source != nullptr && fs::is_symlink(pos.source->name(), ignored))
            candidates.push_back(fs::weakly_canonical(pos.source->name(), ignored).parent_path() / spelt);
    };
    addCandidates(name);
    // Exporters on Windows write folders with backslashes. Here a backslash may be part of a name, which comes first.
    std::string withSlashes = name;
    std::ranges::replace(withSlashes, '\\', '/');
    if (withSlashes != name) addCandidates(withSlashes);
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    std::string tried;
    for (const fs::path& path : candidates) {
        std::error_code ignored;
        const fs::file_status status = fs::status(path, ignored);
        if (fs::is_regular_file(status)) return path.string();
        tried += (tried.empty() ? "" : " and ") + ("'" + path.string() + "'");
        // Pipes and devices may have no end, or block whoever opens them.
        if (fs::exists(status)) tried += fs::is_directory(status) ? ", a folder" : ", which is no file but a device";
    }
    fail(pos, "cannot find the " + what + " '" + name + "'; tried " + tried);
}

}  // namespace drc::pbrt
