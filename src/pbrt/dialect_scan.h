// Finds out, before a scene is read, which dialect it is written in.
#pragma once
#include <memory>

#include "pbrt/dialect.h"
#include "pbrt/file_search.h"

namespace drc::pbrt {

// By the first directive or type that only one of the dialects has, in the file and what it includes: usually within
// its first lines, and no further is read. Where there is none, by the first such parameter; where there is none
// either, it is pbrt-v3. What is malformed or missing ends the search, and is left for the reader to report.
DialectFinding findDialect(std::shared_ptr<const Source> main, const FileSearch& files);

}  // namespace drc::pbrt
