#include "bench/page_equal_time.h"

#include <fmt/core.h>

#include <cmath>

#include "bench/page_measures.h"
#include "report/html_page.h"

namespace drc {
namespace {

const BenchMeasure* const kColumns[] = {&kSsim, &kFlip, &kRelmse, &kSeconds, &kCpuSeconds, &kPeakMegabytes};
constexpr size_t kColumnCount = std::size(kColumns);

std::string block(const std::string& title, const std::string& rows) {
    return fmt::format("<tbody class=\"group\">\n<tr><th class=\"block\" colspan=\"{}\">{}</th></tr>\n{}</tbody>\n",
                       kColumnCount + 1, title, rows);
}

// The best median among the methods; NaN if fewer than two have one.
double bestOf(const std::vector<BenchSpread>& methods, int better) {
    double best = kNotMeasured;
    int count = 0;
    for (const BenchSpread& spread : methods) {
        if (std::isnan(spread.median)) continue;
        if (count++ == 0 || better * spread.median > better * best) best = spread.median;
    }
    return count > 1 && better != 0 ? best : kNotMeasured;
}

std::string failureText(const std::vector<const BenchRun*>& failures, size_t succeeded) {
    const std::string reason = escapeHtml(failures.front()->failure);
    if (succeeded == 0) return reason;
    return fmt::format("{} of {} failed: {}", failures.size(), failures.size() + succeeded, reason);
}

std::string sceneBlock(const BenchReport& report, const std::string& scene, const Budget& budget) {
    std::vector<std::vector<const BenchRun*>> runs;
    for (const std::string& method : report.methods) runs.push_back(runsOf(report, scene, method, budget));
    std::vector<std::string> cells(report.methods.size());
    for (const BenchMeasure* measure : kColumns) {
        std::vector<BenchSpread> spreads;
        for (const auto& ofMethod : runs) spreads.push_back(spreadOver(ofMethod, *measure));
        const double best = bestOf(spreads, measure->better);
        for (size_t m = 0; m < runs.size(); ++m)
            cells[m] +=
                fmt::format("<td{}>{}</td>", spreads[m].median == best ? " class=\"best\"" : "",
                            // Of time and memory the median is enough.
                            measure->better == 0 ? measure->text(spreads[m].median) : spreadText(spreads[m], *measure));
    }
    std::string rows;
    for (size_t m = 0; m < runs.size(); ++m) {
        const auto failures = failuresOf(report, scene, report.methods[m], budget);
        if (runs[m].empty() && failures.empty()) continue;
        const std::string name = fmt::format("<th class=\"name\">{}</th>", escapeHtml(report.methods[m]));
        if (!runs[m].empty()) rows += "<tr>" + name + cells[m] + "</tr>\n";
        if (!failures.empty())
            rows +=
                fmt::format("<tr>{}<td class=\"text failure\" colspan=\"{}\">{}</td></tr>\n",
                            runs[m].empty() ? name : "<th></th>", kColumnCount, failureText(failures, runs[m].size()));
    }
    return rows.empty() ? "" : block(escapeHtml(scene), rows);
}

double medianRelmse(const BenchReport& report, const std::string& scene, const std::string& method,
                    const Budget& budget) {
    return spreadOver(runsOf(report, scene, method, budget), kRelmse).median;
}

struct GeometricMean {
    double ratio = kNotMeasured;
    int scenes = 0;  // that both have
};

GeometricMean relativeError(const BenchReport& report, const std::string& method, const std::string& base,
                            const Budget& budget) {
    double sum = 0;
    GeometricMean mean;
    for (const BenchScene& scene : report.scenes) {
        const double own = medianRelmse(report, scene.name, method, budget),
                     others = medianRelmse(report, scene.name, base, budget);
        if (!(own > 0 && others > 0) || std::isinf(own) || std::isinf(others)) continue;
        sum += std::log(own / others);
        ++mean.scenes;
    }
    if (mean.scenes > 0) mean.ratio = std::exp(sum / mean.scenes);
    return mean;
}

std::string meanBlock(const BenchReport& report, const Budget& budget) {
    const std::string& base = report.methods.front();
    if (relativeError(report, base, base, budget).scenes == 0) return "";
    std::string rows;
    for (const std::string& method : report.methods) {
        const GeometricMean mean = relativeError(report, method, base, budget);
        if (mean.scenes == 0) continue;
        // Under relMSE: what stands there for the single scenes.
        rows += fmt::format(
            "<tr><th class=\"name\">{}</th><td></td><td></td><td>{}&#8201;&#215;</td>"
            "<td class=\"text soft\" colspan=\"3\">{} {}</td></tr>\n",
            escapeHtml(method), htmlSignificant(mean.ratio), mean.scenes, mean.scenes == 1 ? "scene" : "scenes");
    }
    return block(fmt::format("relMSE as a multiple of that of {}, geometric mean", escapeHtml(base)), rows);
}

}  // namespace

std::string equalTimeTables(const BenchReport& report) {
    std::string html;
    for (const Budget& budget : budgetsOf(report, BudgetUnit::Seconds)) {
        std::string blocks;
        for (const BenchScene& scene : report.scenes) blocks += sceneBlock(report, scene.name, budget);
        if (blocks.empty()) continue;
        std::string head = "<thead><tr><th></th>";
        for (const BenchMeasure* measure : kColumns)
            head += fmt::format("<th{}>{}{}</th>", measure->better == 0 ? "" : " class=\"interval\"", measure->title,
                                measure->better > 0   ? " &#8593;"
                                : measure->better < 0 ? " &#8595;"
                                                      : "");
        html += fmt::format(
            "<h3>{}</h3>\n<div class=\"wide\"><table class=\"equal-time\">\n{}</tr></thead>\n{}{}"
            "</table></div>\n",
            budgetName(budget), head, blocks, meanBlock(report, budget));
    }
    return html;
}

}  // namespace drc
