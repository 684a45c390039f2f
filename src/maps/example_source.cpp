#include "maps/example_source.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/log.h"
#include "maps/example_shard.h"
#include "maps/iispt_folder.h"

namespace drc {
namespace fs = std::filesystem;

std::vector<std::string> findExamples(const std::vector<std::string>& paths) {
    std::vector<std::string> found;
    std::set<std::string> folders;
    for (const std::string& path : paths) {
        std::error_code failed;
        if (!fs::exists(path, failed)) throw Error(SourceLocation{path}, "no such file or folder");
        if (!fs::is_directory(path, failed)) {
            found.push_back(path);
            continue;
        }
        fs::recursive_directory_iterator i(path, failed), end;
        for (; !failed && i != end; i.increment(failed)) {
            if (i->path().extension() == kShardExtension) found.push_back(i->path().string());
            if (isIisptFile(i->path().filename().string())) folders.insert(i->path().parent_path().string());
        }
        if (failed) throw Error(SourceLocation{path}, failed.message());
    }
    found.insert(found.end(), folders.begin(), folders.end());
    // Training must not depend on the order in which the file system lists a folder's files.
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::unique_ptr<ExampleSource> openExamples(const std::string& path) {
    std::unique_ptr<ExampleSource> source;
    if (fs::is_directory(path))
        source = std::make_unique<IisptFolder>(path);
    else
        source = std::make_unique<ExampleShard>(path);
    if (!source->damage().empty()) logWarning(source->damage());
    return source;
}

}  // namespace drc
