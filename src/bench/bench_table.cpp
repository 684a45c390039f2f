#include "bench/bench_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "image/pair_metrics.h"

namespace drc {
namespace {

using Row = std::vector<std::string>;

using Runs = std::vector<const BenchRun*>;

double median(const Runs& runs, double BenchRun::*value) {
    std::vector<double> values;
    for (const BenchRun* run : runs) values.push_back(run->*value);
    return spreadOf(values).median;
}

std::string number(double x, int digits) { return std::isnan(x) ? "-" : fmt::format("{:.{}f}", x, digits); }
std::string number(const Runs& runs, double BenchRun::*value, int digits) {
    return number(median(runs, value), digits);
}

// "0.00123 ± 0.00004".
std::string error(const Runs& runs, double BenchRun::*value, double BenchRun::*standardError) {
    const double x = median(runs, value), se = median(runs, standardError);
    if (std::isnan(x)) return "-";
    return fmt::format("{:.5f}", x) + (std::isnan(se) ? "" : fmt::format(" \u00b1 {:.5f}", se));
}

// With ~ before it where the references' noise, by which a perfect picture would miss `perfect`, has a large share.
std::string displayed(const Runs& runs, double BenchRun::*value, double perfect, double noise, bool& anyNoisy) {
    const double x = median(runs, value);
    const bool noisy = noise > kMostDisplayedNoise * std::abs(x - perfect);
    anyNoisy |= noisy;
    return (noisy ? "~" : "") + number(x, 4);
}

std::string ratios(const Runs& runs) {
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

// In characters: of UTF-8 the bytes that begin one.
size_t width(const std::string& text) {
    return size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string aligned(const std::vector<Row>& rows) {
    std::vector<size_t> widths(rows[0].size());
    for (const Row& row : rows)
        for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    std::string text;
    for (size_t r = 0; r < rows.size(); ++r) {
        for (size_t i = 0; i < widths.size(); ++i) {
            const std::string cell = i < rows[r].size() ? rows[r][i] : "";
            text += "| " + cell + std::string(widths[i] - width(cell) + 1, ' ');
        }
        text += "|\n";
        if (r > 0) continue;
        for (const size_t wide : widths) text += fmt::format("|{:-<{}}", "", wide + 2);
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

Row rowOf(const BenchReport& report, const BenchScene& scene, const std::string& method, const Budget& budget,
          const Runs& runs, bool& anyNoisy) {
    return {inCell(scene.name),
            inCell(method),
            error(runs, &BenchRun::error, &BenchRun::errorSe),
            error(runs, &BenchRun::trimmedError, &BenchRun::trimmedErrorSe),
            error(runs, &BenchRun::blockError, &BenchRun::blockErrorSe),
            number(median(runs, &BenchRun::error) / opponentError(report, scene.name, budget), 2),
            displayed(runs, &BenchRun::ssim, 1, scene.ssimNoise, anyNoisy),
            displayed(runs, &BenchRun::flip, 0, scene.flipNoise, anyNoisy),
            ratios(runs),
            number(runs, &BenchRun::spp, 0),
            number(runs, &BenchRun::loadSeconds, 1),
            number(runs, &BenchRun::renderSeconds, 1),
            number(runs, &BenchRun::denoiseSeconds, 1),
            number(runs, &BenchRun::writeSeconds, 1),
            number(runs, &BenchRun::seconds, 1),
            number(runs, &BenchRun::peakMegabytes, 0)};
}

}  // namespace

std::string benchMarkdown(const BenchReport& report) {
    std::string text;
    for (const Budget& budget : report.budgets) {
        std::string notes, modes;
        bool anyNoisy = false;
        std::vector<Row> rows{{"scene", "method", "error", "trimmed", "8x8 blocks", "/ path+oidn", "SSIM", "FLIP",
                               "mean ratio RGB", "spp", "load s", "render s", "denoise s", "write s", "whole s", "MB"}};
        for (const BenchScene& scene : report.scenes) {
            const size_t before = rows.size();
            for (const std::string& method : report.methods) {
                const auto runs = runsOf(report, scene.name, method, budget);
                const std::string failure = failureOf(report, scene.name, method, budget);
                if (!runs.empty())
                    rows.push_back(rowOf(report, scene, method, budget, runs, anyNoisy));
                else if (!failure.empty()) {
                    rows.push_back({inCell(scene.name), inCell(method), "-"});
                    notes += fmt::format("- {}, {}: {}\n", scene.name, method, failure);
                }
                if (!runs.empty() && !runs[0]->oidnMode.empty() && method.find(':') == std::string::npos)
                    modes += fmt::format("- {}, {}: Open Image Denoise in the mode {}\n", scene.name, method,
                                         runs[0]->oidnMode);
            }
            if (rows.size() > before && scene.pair.empty())
                notes += fmt::format("- {}: one reference only; its noise is in the errors (relMSE)\n", scene.name);
        }
        if (anyNoisy)
            notes += fmt::format("- ~: more than {:.0f} % of the difference is the references' own noise\n",
                                 100 * kMostDisplayedNoise);
        if (rows.size() > 1) text += fmt::format("## {}\n\n{}\n", budgetName(budget), aligned(rows));
        if (!(notes + modes).empty()) text += notes + modes + "\n";
    }
    return text;
}

}  // namespace drc
