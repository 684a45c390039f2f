// The part of a comparison's page that compares methods at equal time.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// For each budget in seconds a table: a block for each scene, a row for each method, and the geometric means of the
// methods' errors over the scenes, as multiples of the error of the best path+oidn, or of the first method if there is
// none. Empty without such budgets.
std::string equalTimeTables(const BenchReport& report);

}  // namespace drc
