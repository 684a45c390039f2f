// The part of a comparison's page with the paper's own tables: quality, time and PNG size against tasks and samples.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// For each scene with budgets in tasks or samples: a row for each amount, three columns for each method, and, beyond
// the paper's tables, the quality of a method with tasks and one with samples after the same time. Empty if there are
// none.
std::string paperTables(const BenchReport& report);

// The SSIM of a method with budgets in that unit after so many seconds, interpolated between two of its runs, linearly
// in the logarithm of time. NaN before the first and after the last run.
double ssimAfter(const BenchReport& report, const std::string& scene, const std::string& method, BudgetUnit unit,
                 double seconds);

}  // namespace drc
