// Determines the dialect of a scene file before it is read.
#pragma once
#include <memory>

#include "pbrt/dialect.h"
#include "pbrt/file_search.h"

namespace drc::pbrt {

// Searches the file and everything that it includes for the first directive or type that is exclusive to a dialect,
// which is usually in the first lines. If there is none, the first exclusive parameter decides; if there is none
// either, the dialect is pbrt-v3. The search ends silently where the file is malformed or a file is missing: the parser
// reports that.
DialectFinding findDialect(std::shared_ptr<const Source> main, const FileSearch& files);

}  // namespace drc::pbrt
