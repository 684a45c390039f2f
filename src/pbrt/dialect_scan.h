// Determines the dialect of a scene file before it is read.
#pragma once
#include <memory>

#include "pbrt/dialect.h"
#include "pbrt/file_search.h"

namespace drc::pbrt {

// The first directive or type that is exclusive to a dialect decides, searched for in the file and everything it
// includes; it is usually in the first lines. Failing that, the first such parameter decides, and failing that too, it
// is pbrt-v3. The search ends silently where the file is malformed or missing, which is left to the parser to report.
DialectFinding findDialect(std::shared_ptr<const Source> main, const FileSearch& files);

}  // namespace drc::pbrt
