// Finds the files that a scene names.
#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <unordered_set>
#include <vector>

#include "pbrt/source.h"

namespace drc::pbrt {

class FileSearch {
  public:
    explicit FileSearch(std::string mainDirectory) : mainDirectory_(std::move(mainDirectory)) {}
    // The path of a file that is named at pos. An absolute path is used as it is. A relative one is searched for in the
    // folder of the naming file, then in that of the main scene file, then in the folder that a symbolic link to the
    // naming file points to; if all fail, again with / for every backslash. Throws Error at pos that lists every path
    // tried. `what` is used in messages: "texture", "ply file", ...
    std::string find(const std::string& name, const SourcePos& pos, const std::string& what) const;

    // The paths found so far, each once, in the order in which they were first named.
    std::vector<std::string> found() const;

  private:
    std::string note(const std::string& path) const;

    struct Found {
        std::mutex mutex;
        std::vector<std::string> paths;
        std::unordered_set<std::string> known;
    };
    std::string mainDirectory_;
    std::shared_ptr<Found> found_ = std::make_shared<Found>();  // shared by all copies of this object
};

}  // namespace drc::pbrt
