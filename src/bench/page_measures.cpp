#include "bench/page_measures.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/html_page.h"

namespace drc {
namespace {

std::string decimals(double x, int count) { return std::isnan(x) ? htmlNumber(x) : fmt::format("{:.{}f}", x, count); }

}  // namespace

std::string fourDecimals(double x) { return htmlNumber(x); }
std::string twoDecimals(double x) { return decimals(x, 2); }
std::string oneDecimal(double x) { return decimals(x, 1); }
std::string noDecimals(double x) { return decimals(x, 0); }

const BenchMeasure kSsim{"SSIM", &BenchRun::ssim, fourDecimals, 1};
const BenchMeasure kFlip{"FLIP", &BenchRun::flip, fourDecimals, -1};
const BenchMeasure kError{"error", &BenchRun::error, htmlSignificant, -1, &BenchRun::errorSe};
const BenchMeasure kTrimmedError{"trimmed", &BenchRun::trimmedError, htmlSignificant, -1, &BenchRun::trimmedErrorSe};
const BenchMeasure kBlockError{"blocks", &BenchRun::blockError, htmlSignificant, -1, &BenchRun::blockErrorSe};
const BenchMeasure kSpp{"spp", &BenchRun::spp, noDecimals, 0};
const BenchMeasure kLoadSeconds{"load", &BenchRun::loadSeconds, twoDecimals, 0};
const BenchMeasure kRenderSeconds{"render", &BenchRun::renderSeconds, twoDecimals, 0};
const BenchMeasure kDenoiseSeconds{"denoise", &BenchRun::denoiseSeconds, twoDecimals, 0};
const BenchMeasure kWriteSeconds{"write", &BenchRun::writeSeconds, twoDecimals, 0};
const BenchMeasure kSeconds{"seconds", &BenchRun::seconds, twoDecimals, 0};
const BenchMeasure kCpuSeconds{"CPU s", &BenchRun::cpuSeconds, oneDecimal, 0};
const BenchMeasure kPeakMegabytes{"peak MB", &BenchRun::peakMegabytes, noDecimals, 0};
const BenchMeasure kPngKb{"PNG KB", &BenchRun::pngKb, oneDecimal, 0};

MeasuredSpread spreadOver(const std::vector<const BenchRun*>& runs, const BenchMeasure& measure) {
    std::vector<double> values, errors;
    for (const BenchRun* run : runs) {
        values.push_back(run->*measure.value);
        if (measure.standardError) errors.push_back(run->*measure.standardError);
    }
    return {spreadOf(values), spreadOf(errors).median};
}

std::string spreadText(const MeasuredSpread& spread, const BenchMeasure& measure) {
    std::string small;
    if (!std::isnan(spread.standardError)) small += "&#177;&#8202;" + measure.text(spread.standardError);
    if (spread.count > 1)
        small += (small.empty() ? "" : "; ") + measure.text(spread.low) + "&#8202;&#8211;&#8202;" +
                 measure.text(spread.high);
    return measure.text(spread.median) + (small.empty() ? "" : "<small>" + small + "</small>");
}

std::vector<const BenchRun*> failuresOf(const BenchReport& report, const std::string& scene, const std::string& method,
                                        const Budget& budget) {
    std::vector<const BenchRun*> runs;
    for (const BenchRun& run : report.runs)
        if (run.scene == scene && run.method == method && run.budget == budget && !run.failure.empty())
            runs.push_back(&run);
    return runs;
}

std::vector<Budget> budgetsOf(const BenchReport& report, BudgetUnit unit) {
    std::vector<Budget> budgets;
    for (const Budget& budget : report.budgets)
        if (budget.unit == unit) budgets.push_back(budget);
    std::sort(budgets.begin(), budgets.end(), [](const Budget& a, const Budget& b) { return a.amount < b.amount; });
    budgets.erase(std::unique(budgets.begin(), budgets.end()), budgets.end());
    return budgets;
}

int methodColour(size_t method) {
    constexpr std::array<int, 8> kOrder{2, 5, 3, 1, 4, 6, 7, 0};  // the first ones differ most
    return kOrder[method % kOrder.size()];
}

}  // namespace drc
