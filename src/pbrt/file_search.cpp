#include "pbrt/file_search.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace drc::pbrt {
namespace fs = std::filesystem;

std::string FileSearch::find(const std::string& name, const SourcePos& pos, const std::string& what) const {
    if (name.empty()) fail(pos, "the name of the " + what + " is empty");
    std::vector<fs::path> candidates;
    if (fs::path(name).is_absolute()) {
        candidates.push_back(name);
    } else {
        if (pos.source != nullptr) candidates.push_back(fs::path(pos.source->directory()) / name);
        const fs::path fromMain = fs::path(mainDirectory_) / name;
        if (std::find(candidates.begin(), candidates.end(), fromMain) == candidates.end())
            candidates.push_back(fromMain);
    }
    std::string tried;
    for (const fs::path& path : candidates) {
        std::error_code ignored;
        if (fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return path.string();
        tried += (tried.empty() ? "" : " and ") + ("'" + path.string() + "'");
    }
    fail(pos, "cannot find the " + what + " '" + name + "'; tried " + tried);
}

}  // namespace drc::pbrt
