// The parts of a comparison's page that are drawn: error against time, memory against tasks.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Per scene a plot each of the error, 1 - SSIM and FLIP against the seconds of the process, both logarithmic: a line a
// method and unit of its budgets. Empty if no method has two budgets.
std::string errorCurves(const BenchReport& report);

// Per scene the peak memory of the methods that were given tasks, and by how much it grew. Empty if none was given two
// numbers of tasks.
std::string memoryCurves(const BenchReport& report);

}  // namespace drc
