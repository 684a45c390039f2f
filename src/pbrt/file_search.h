// Where the files that a scene names are looked for.
#pragma once
#include <string>

#include "pbrt/source.h"

namespace drc::pbrt {

class FileSearch {
  public:
    explicit FileSearch(std::string mainDirectory) : mainDirectory_(std::move(mainDirectory)) {}
    // The path of a file that is named at pos: as it is if absolute, else in the directory of the file that names it,
    // else in the main scene file's directory, else where a link to the naming file leads. Throws Error at pos with
    // every path that was tried. `what` is for the message: "texture", "ply file", ...
    std::string find(const std::string& name, const SourcePos& pos, const std::string& what) const;

  private:
    std::string mainDirectory_;
};

}  // namespace drc::pbrt
