// A comparison's results as Markdown, for documents.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// A table a budget, as lines of text: scene, method, seconds of the process, SSIM, FLIP, relMSE, mean ratios,
// megabytes. Medians over repeats. What failed has a dash, and what it said below the table.
std::string benchMarkdown(const BenchReport& report);

}  // namespace drc
