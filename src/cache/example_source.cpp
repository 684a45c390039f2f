#include "cache/example_source.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/log.h"
#include "cache/example_shard.h"

namespace drc {
namespace fs = std::filesystem;

std::vector<std::string> findExamples(const std::vector<std::string>& paths) {
    std::vector<std::string> found;
    for (const std::string& path : paths) {
        std::error_code failed;
        if (!fs::exists(path, failed)) throw Error(SourceLocation{path}, "no such file or folder");
        if (!fs::is_directory(path, failed)) {
            found.push_back(path);
            continue;
        }
        fs::recursive_directory_iterator i(path, failed), end;
        for (; !failed && i != end; i.increment(failed))
            if (i->path().extension() == kShardExtension) found.push_back(i->path().string());
        if (failed) throw Error(SourceLocation{path}, failed.message());
    }
    // The order in which a folder is listed must not change the training.
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::unique_ptr<ExampleSource> openExamples(const std::string& path) {
    auto source = std::make_unique<ExampleShard>(path);
    if (!source->damage().empty()) logWarning(source->damage());
    return source;
}

}  // namespace drc
