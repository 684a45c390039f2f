// A comparison's results as Markdown, for documents.
#pragma once
#include <string>

#include "bench/bench_result.h"

namespace drc {

// One table for each budget, as lines of text: scene, method, errors with their standard errors, the error as a
// multiple of the opponent's, SSIM, FLIP, mean ratios, samples a pixel, seconds by phase, megabytes. Values are medians
// over repeats; a standard error is that of one run. Failed runs have a dash, and their message is below the table.
// Notes below it also warn of unreliable figures: those with the noise of a single reference, and SSIM and FLIP (marked
// ~) of which the noise of the pair is too large a share.
std::string benchMarkdown(const BenchReport& report);

}  // namespace drc
