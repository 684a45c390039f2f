#include "bench/bench_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

using Row = std::vector<std::string>;

std::string number(const std::vector<const BenchRun*>& runs, double BenchRun::*value, int digits) {
    std::vector<double> values;
    for (const BenchRun* run : runs) values.push_back(run->*value);
    const double median = spreadOf(values).median;
    return std::isnan(median) ? "-" : fmt::format("{:.{}f}", median, digits);
}

std::string ratios(const std::vector<const BenchRun*>& runs) {
    std::string text;
    for (size_t c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (const BenchRun* run : runs) values.push_back(run->meanRatio[c]);
        text += fmt::format("{}{:.3f}", c ? " " : "", spreadOf(values).median);
    }
    return text;
}

// A column ends at each bar.
std::string inCell(std::string text) {
    for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string aligned(const std::vector<Row>& rows) {
    std::vector<size_t> widths(rows[0].size());
    for (const Row& row : rows)
        for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (size_t r = 0; r < rows.size(); ++r) {
        for (size_t i = 0; i < widths.size(); ++i)
            text += fmt::format("| {:<{}} ", i < rows[r].size() ? rows[r][i] : "", widths[i]);
        text += "|\n";
        if (r > 0) continue;
        for (const size_t width : widths) text += fmt::format("|{:-<{}}", "", width + 2);
        text += "|\n";
    }
    return text;
}

std::string failureOf(const BenchReport& report, const std::string& scene, const std::string& method,
                      const Budget& budget) {
    for (const BenchRun& run : report.runs)
        if (run.scene == scene && run.method == method && run.budget == budget) return run.failure;
    return "";
}

}  // namespace

std::string benchMarkdown(const BenchReport& report) {
    std::string text;
    for (const Budget& budget : report.budgets) {
        std::string failures;
        std::vector<Row> rows{{"scene", "method", "seconds", "SSIM", "FLIP", "relMSE", "mean ratio RGB", "MB"}};
        for (const BenchScene& scene : report.scenes)
            for (const std::string& method : report.methods) {
                const auto runs = runsOf(report, scene.name, method, budget);
                const std::string failure = failureOf(report, scene.name, method, budget);
                if (!runs.empty())
                    rows.push_back({inCell(scene.name), inCell(method), number(runs, &BenchRun::seconds, 1),
                                    number(runs, &BenchRun::ssim, 4), number(runs, &BenchRun::flip, 4),
                                    number(runs, &BenchRun::relmse, 5), ratios(runs),
                                    number(runs, &BenchRun::peakMegabytes, 0)});
                else if (!failure.empty()) {
                    rows.push_back({inCell(scene.name), inCell(method), "-"});
                    failures += fmt::format("- {}, {}: {}\n", scene.name, method, failure);
                }
            }
        if (rows.size() > 1) text += fmt::format("## {}\n\n{}\n", budgetName(budget), aligned(rows));
        if (!failures.empty()) text += failures + "\n";
    }
    return text;
}

}  // namespace drc
