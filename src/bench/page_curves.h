// The plots of a comparison's page: error against time, and memory against tasks.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// For each scene, plots of the error, 1 - SSIM and FLIP against the seconds of the process, both axes logarithmic, with
// a line for each method and unit of its budgets. Empty if no method has two budgets.
std::string errorCurves(const BenchReport& report);

// For each scene, the peak memory of the methods with budgets in tasks, and its growth. Empty if no method has two
// numbers of tasks.
std::string memoryCurves(const BenchReport& report);

}  // namespace drc
