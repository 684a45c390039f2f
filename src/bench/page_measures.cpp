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
const BenchMeasure kRelmse{"relMSE", &BenchRun::relmse, htmlSignificant, -1};
const BenchMeasure kMse{"MSE", &BenchRun::mse, htmlSignificant, -1};
const BenchMeasure kSeconds{"seconds", &BenchRun::seconds, twoDecimals, 0};
const BenchMeasure kCpuSeconds{"CPU s", &BenchRun::cpuSeconds, oneDecimal, 0};
const BenchMeasure kPeakMegabytes{"peak MB", &BenchRun::peakMegabytes, noDecimals, 0};
const BenchMeasure kPngKb{"PNG KB", &BenchRun::pngKb, oneDecimal, 0};

BenchSpread spreadOver(const std::vector<const BenchRun*>& runs, const BenchMeasure& measure) {
    std::vector<double> values;
    for (const BenchRun* run : runs) values.push_back(run->*measure.value);
    return spreadOf(values);
}

std::string spreadText(const BenchSpread& spread, const BenchMeasure& measure) {
    std::string html = measure.text(spread.median);
    if (spread.count > 1)
        html += "<small>" + measure.text(spread.low) + "&#8202;&#8211;&#8202;" + measure.text(spread.high) + "</small>";
    return html;
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
