// The page of `drc bench`: one file with tables, pictures to compare and curves; it opens from disk and fetches
// nothing.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Pictures are read from `folder`, where their paths are relative. Throws Error, naming the file, on one that cannot be
// shown. What there are no runs for has no section.
std::string benchPage(const BenchReport& report, const std::string& folder);

}  // namespace drc
