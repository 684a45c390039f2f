// Which parameters name files that a scene is read from.
#pragma once
#include <string>

#include "pbrt/file_search.h"
#include "pbrt/param_set.h"

namespace drc::pbrt {

// Whether strings of this parameter name files, as far as they are not names that pbrt itself knows ("metal-Cu-eta").
// The "filename" of a film is not meant: it is written, not read.
bool namesFile(std::string_view typeName, std::string_view name);

// The absolute path of the file that is named at pos; the name itself if there is no such file.
std::string absolutePath(const std::string& name, const SourcePos& pos, const FileSearch& files);

}  // namespace drc::pbrt
