// A comparison's results as Markdown, for documents.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// A table a budget, as lines of text: scene, method, errors with their standard errors, the error as a multiple of the
// opponent's, SSIM, FLIP, mean ratios, samples a pixel, seconds by what they were spent on, megabytes. Medians over
// repeats; a standard error is that of one run. What failed has a dash, and what it said below the table; there it also
// says what the figures are not to be trusted for: the noise of single references, and SSIM and FLIP (marked ~) that
// the noise of a pair has too large a share in.
std::string benchMarkdown(const BenchReport& report);

}  // namespace drc
