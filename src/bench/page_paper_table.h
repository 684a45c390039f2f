// The part of a comparison's page that repeats the paper's own: quality, time and PNG size against tasks and samples.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// Per scene with budgets in tasks or samples: a row an amount, three columns a method; and, beside the paper's, how far
// a method of tasks and one of samples came in the same time. Empty if there are none.
std::string paperTables(const BenchReport& report);

// The SSIM that a method with budgets of that unit has after so many seconds: between two of its runs, linear in the
// logarithm of time. NaN before the first and after the last.
double ssimAfter(const BenchReport& report, const std::string& scene, const std::string& method, BudgetUnit unit,
                 double seconds);

}  // namespace drc
