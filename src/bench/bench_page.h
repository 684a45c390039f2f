// The page of `drc bench`: a single file with tables, pictures to compare and curves. It opens from disk and loads
// nothing else.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Pictures are read from `folder`, to which their paths are relative. Throws Error, naming the file, if one cannot be
// shown. Sections without runs are left out.
std::string benchPage(const BenchReport& report, const std::string& folder);

}  // namespace drc
