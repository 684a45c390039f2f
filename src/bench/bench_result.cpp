#include "bench/bench_result.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace drc {

std::string budgetName(const Budget& budget) {
    const char* tasks = budget.amount == 1 ? "task" : "tasks";
    const char* unit = budget.unit == BudgetUnit::Seconds ? "s" : budget.unit == BudgetUnit::Spp ? "spp" : tasks;
    return fmt::format("{:g} {}", budget.amount, unit);
}

BenchSpread spreadOf(std::vector<double> values) {
    std::erase_if(values, [](double x) { return std::isnan(x); });
    BenchSpread spread;
    const auto n = values.size();
    spread.count = int(n);
    if (n == 0) return spread;
    std::sort(values.begin(), values.end());
    spread.median = (values[(n - 1) / 2] + values[n / 2]) / 2;
    // The median lies outside of [x_k, x_(n-1-k)] with probability 2 P(B <= k), B binomial of n throws and 1/2.
    double outside = 2 * std::exp2(-double(n)), term = outside;
    size_t k = 0;
    for (;; ++k) {
        term *= double(n - k) / double(k + 1);
        if (outside + term > 0.05 || 2 * (k + 1) >= n) break;
        outside += term;
    }
    spread.low = values[k], spread.high = values[n - 1 - k];
    return spread;
}

std::vector<const BenchRun*> runsOf(const BenchReport& report, const std::string& scene, const std::string& method,
                                    const Budget& budget) {
    std::vector<const BenchRun*> runs;
    for (const BenchRun& run : report.runs)
        if (run.scene == scene && run.method == method && run.budget == budget && run.failure.empty())
            runs.push_back(&run);
    return runs;
}

double opponentError(const BenchReport& report, const std::string& scene, const Budget& budget) {
    double best = kNotMeasured;
    for (const std::string& method : report.methods) {
        if (method != kOpponent && !method.starts_with(std::string(kOpponent) + ":")) continue;
        std::vector<double> errors;
        for (const BenchRun* run : runsOf(report, scene, method, budget)) errors.push_back(run->error);
        best = std::fmin(best, spreadOf(errors).median);  // fmin passes by NaN
    }
    return best > 0 ? best : kNotMeasured;  // a cross error of nearly nothing may be below zero
}

}  // namespace drc
