// Definitions that the parts of a comparison's page share: the quantities, how each is written, and which runs there
// are.
#pragma once
#include <string>
#include <vector>

#include "bench/bench_result.h"

namespace drc {

struct BenchMeasure {
    const char* title;
    double BenchRun::*value;
    std::string (*text)(double);                // as HTML; a dash for NaN
    int better;                                 // 1: larger is better; -1: smaller is; 0: neither
    double BenchRun::*standardError = nullptr;  // null if there is none
};

std::string fourDecimals(double x);  // htmlNumber
std::string twoDecimals(double x);
std::string oneDecimal(double x);
std::string noDecimals(double x);

extern const BenchMeasure kError, kTrimmedError, kBlockError, kSsim, kFlip, kSpp, kLoadSeconds, kRenderSeconds,
    kDenoiseSeconds, kWriteSeconds, kSeconds, kCpuSeconds, kPeakMegabytes, kPngKb;

struct MeasuredSpread : BenchSpread {
    double standardError = kNotMeasured;  // median over the runs
};
MeasuredSpread spreadOver(const std::vector<const BenchRun*>& runs, const BenchMeasure& measure);

// The median and, in small type, the standard error of a run, if there is one, and the range of the repeats, if there
// are several.
std::string spreadText(const MeasuredSpread& spread, const BenchMeasure& measure);

// The failed repeats.
std::vector<const BenchRun*> failuresOf(const BenchReport& report, const std::string& scene, const std::string& method,
                                        const Budget& budget);

// The budgets in that unit, smallest first, each once.
std::vector<Budget> budgetsOf(const BenchReport& report, BudgetUnit unit);

// The colour of a method (html_page.h), the same on the whole page.
int methodColour(size_t method);

}  // namespace drc
