#include "bench/page_equal_time.h"

#include <fmt/core.h>

#include <cmath>

#include "bench/page_measures.h"
#include "image/pair_metrics.h"
#include "report/html_page.h"

namespace drc {
namespace {

const BenchMeasure* const kColumns[] = {&kError,   &kTrimmedError, &kBlockError,    &kSsim,           &kFlip,
                                        &kSpp,     &kLoadSeconds,  &kRenderSeconds, &kDenoiseSeconds, &kWriteSeconds,
                                        &kSeconds, &kCpuSeconds,   &kPeakMegabytes};
constexpr size_t kColumnCount = std::size(kColumns) + 1;  // and, beside the error, its ratio to the opponent's

std::string block(const std::string& title, const std::string& rows) {
    return fmt::format("<tbody class=\"group\">\n<tr><th class=\"block\" colspan=\"{}\">{}</th></tr>\n{}</tbody>\n",
                       kColumnCount + 1, title, rows);
}

// Whether a median is better than another by more than what is known of their errors: the standard errors of both
// together and, of several repeats, the intervals, which must not overlap.
bool isClearlyBetter(const MeasuredSpread& a, const MeasuredSpread& b, int better) {
    const auto squared = [](double error) { return std::isnan(error) ? 0 : error * error; };
    if (!(better * (a.median - b.median) > std::sqrt(squared(a.standardError) + squared(b.standardError))))
        return false;
    const bool overlap = better > 0 ? a.low <= b.high : a.high >= b.low;
    return a.count < 2 || b.count < 2 || !overlap;
}

// The best median among the methods, which several may have; NaN if fewer than two have one, or if it is not clearly
// better than all others.
double bestOf(const std::vector<MeasuredSpread>& methods, int better) {
    const MeasuredSpread* best = nullptr;
    int count = 0;
    for (const MeasuredSpread& spread : methods) {
        if (std::isnan(spread.median)) continue;
        if (count++ == 0 || better * spread.median > better * best->median) best = &spread;
    }
    if (count < 2 || better == 0) return kNotMeasured;
    for (const MeasuredSpread& spread : methods)
        if (!std::isnan(spread.median) && spread.median != best->median && !isClearlyBetter(*best, spread, better))
            return kNotMeasured;
    return best->median;
}

std::string failureText(const std::vector<const BenchRun*>& failures, size_t succeeded) {
    const std::string reason = escapeHtml(failures.front()->failure);
    if (succeeded == 0) return reason;
    return fmt::format("{} of {} failed: {}", failures.size(), failures.size() + succeeded, reason);
}

// Where a perfect picture would be by this measure, and how far the references' noise puts it from there.
struct Displayed {
    double perfect = 0, noise = 0;
    bool isNoisy(double value) const { return noise > kMostDisplayedNoise * std::abs(value - perfect); }
};

Displayed displayed(const BenchScene& scene, const BenchMeasure* measure) {
    return measure == &kSsim   ? Displayed{1, scene.ssimNoise}
           : measure == &kFlip ? Displayed{0, scene.flipNoise}
                               : Displayed{};
}

std::string sceneBlock(const BenchReport& report, const BenchScene& scene, const Budget& budget) {
    std::vector<std::vector<const BenchRun*>> runs;
    for (const std::string& method : report.methods) runs.push_back(runsOf(report, scene.name, method, budget));
    std::vector<std::string> cells(report.methods.size());
    const double opponent = opponentError(report, scene.name, budget);
    for (const BenchMeasure* measure : kColumns) {
        std::vector<MeasuredSpread> spreads;
        for (const auto& ofMethod : runs) spreads.push_back(spreadOver(ofMethod, *measure));
        const Displayed shown = displayed(scene, measure);
        double best = bestOf(spreads, measure->better);
        if (shown.isNoisy(best)) best = kNotMeasured;
        for (size_t m = 0; m < runs.size(); ++m) {
            cells[m] +=
                fmt::format("<td{}>{}{}</td>", spreads[m].median == best ? " class=\"best\"" : "",
                            shown.isNoisy(spreads[m].median) ? "~" : "",
                            // Time and memory are shown as medians alone, without their spread.
                            measure->better == 0 ? measure->text(spreads[m].median) : spreadText(spreads[m], *measure));
            if (measure == &kError) cells[m] += "<td>" + twoDecimals(spreads[m].median / opponent) + "</td>";
        }
    }
    std::string rows;
    for (size_t m = 0; m < runs.size(); ++m) {
        const auto failures = failuresOf(report, scene.name, report.methods[m], budget);
        if (runs[m].empty() && failures.empty()) continue;
        const std::string name = fmt::format("<th class=\"name\">{}</th>", escapeHtml(report.methods[m]));
        if (!runs[m].empty()) rows += "<tr>" + name + cells[m] + "</tr>\n";
        if (!failures.empty())
            rows +=
                fmt::format("<tr>{}<td class=\"text failure\" colspan=\"{}\">{}</td></tr>\n",
                            runs[m].empty() ? name : "<th></th>", kColumnCount, failureText(failures, runs[m].size()));
    }
    return rows.empty() ? "" : block(escapeHtml(scene.name), rows);
}

double medianError(const BenchReport& report, const std::string& scene, const std::string& method,
                   const Budget& budget) {
    return spreadOver(runsOf(report, scene, method, budget), kError).median;
}

// The method whose error is the unit of relative errors: the opponent, or the first method if that was not run.
struct Base {
    bool isOpponent;
    std::string method;
    double error(const BenchReport& report, const std::string& scene, const Budget& budget) const {
        return isOpponent ? opponentError(report, scene, budget) : medianError(report, scene, method, budget);
    }
};

Base baseOf(const BenchReport& report, const Budget& budget) {
    for (const BenchScene& scene : report.scenes)
        if (!std::isnan(opponentError(report, scene.name, budget))) return {true, std::string("the best ") + kOpponent};
    return {false, report.methods.front()};
}

struct GeometricMean {
    double ratio = kNotMeasured;
    int scenes = 0;  // that both have
};

GeometricMean relativeError(const BenchReport& report, const std::string& method, const Base& base,
                            const Budget& budget) {
    double sum = 0;
    GeometricMean mean;
    for (const BenchScene& scene : report.scenes) {
        const double own = medianError(report, scene.name, method, budget),
                     others = base.error(report, scene.name, budget);
        if (!(own > 0 && others > 0) || std::isinf(own) || std::isinf(others)) continue;
        sum += std::log(own / others);
        ++mean.scenes;
    }
    if (mean.scenes > 0) mean.ratio = std::exp(sum / mean.scenes);
    return mean;
}

std::string meanBlock(const BenchReport& report, const Budget& budget) {
    const Base base = baseOf(report, budget);
    std::string rows;
    bool any = base.isOpponent;
    for (const std::string& method : report.methods) {
        const GeometricMean mean = relativeError(report, method, base, budget);
        if (mean.scenes == 0) continue;
        any |= method == base.method;
        // Under the error: what stands there for the single scenes.
        rows += fmt::format(
            "<tr><th class=\"name\">{}</th><td>{}&#8201;&#215;</td><td class=\"text soft\" colspan=\"{}\">{} "
            "{}</td></tr>\n",
            escapeHtml(method), htmlSignificant(mean.ratio), kColumnCount - 1, mean.scenes,
            mean.scenes == 1 ? "scene" : "scenes");
    }
    if (!any) return "";
    return block(fmt::format("error as a multiple of that of {}, geometric mean", escapeHtml(base.method)), rows);
}

}  // namespace

std::string equalTimeTables(const BenchReport& report) {
    std::string html;
    for (const Budget& budget : budgetsOf(report, BudgetUnit::Seconds)) {
        std::string blocks;
        for (const BenchScene& scene : report.scenes) blocks += sceneBlock(report, scene, budget);
        if (blocks.empty()) continue;
        std::string head = "<thead><tr><th></th>";
        for (const BenchMeasure* measure : kColumns) {
            head += fmt::format("<th{}>{}{}</th>", measure->better == 0 ? "" : " class=\"interval\"", measure->title,
                                measure->better > 0   ? " &#8593;"
                                : measure->better < 0 ? " &#8595;"
                                                      : "");
            if (measure == &kError) head += fmt::format("<th>/ {}</th>", kOpponent);
        }
        html += fmt::format(
            "<h3>{}</h3>\n<div class=\"wide\"><table class=\"equal-time\">\n{}</tr></thead>\n{}{}"
            "</table></div>\n",
            budgetName(budget), head, blocks, meanBlock(report, budget));
    }
    return html;
}

}  // namespace drc
