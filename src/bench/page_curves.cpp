#include "bench/page_curves.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/page_measures.h"
#include "report/html_page.h"
#include "report/svg_line_plot.h"

namespace drc {
namespace {

constexpr BudgetUnit kUnits[] = {BudgetUnit::Seconds, BudgetUnit::Spp, BudgetUnit::Tasks};

PlotMark markOf(BudgetUnit unit) {
    return unit == BudgetUnit::Seconds ? PlotMark::Circle
           : unit == BudgetUnit::Spp   ? PlotMark::Square
                                       : PlotMark::Diamond;
}

struct Error {
    const char* title;
    BenchMeasure measure;
    double of(double value) const { return measure.better > 0 ? 1 - value : value; }
};
const Error kErrors[] = {{"error", kError}, {"1 \u2212 SSIM", kSsim}, {"FLIP", kFlip}};

LinePlotPoint errorPoint(const std::vector<const BenchRun*>& runs, const Error& error) {
    const BenchSpread spread = spreadOver(runs, error.measure);
    LinePlotPoint point{spreadOver(runs, kSeconds).median, error.of(spread.median), ""};
    if (spread.count > 1) {
        point.low = std::min(error.of(spread.low), error.of(spread.high));
        point.high = std::max(error.of(spread.low), error.of(spread.high));
    }
    return point;
}

std::vector<LinePlotSeries> errorSeries(const BenchReport& report, const std::string& scene, const Error& error) {
    std::vector<LinePlotSeries> series;
    for (size_t m = 0; m < report.methods.size(); ++m)
        for (const BudgetUnit unit : kUnits) {
            LinePlotSeries one{report.methods[m], {}, methodColour(m), markOf(unit)};
            for (const Budget& budget : budgetsOf(report, unit)) {
                LinePlotPoint point = errorPoint(runsOf(report, scene, one.label, budget), error);
                if (!(point.x > 0 && point.y > 0)) continue;
                point.title = fmt::format("{}, {}: {} {:.4g} in {:.2f} s", one.label, budgetName(budget), error.title,
                                          point.y, point.x);
                one.points.push_back(point);
            }
            if (!one.points.empty()) series.push_back(one);
        }
    return series;
}

// Around all of the values of the points.
template <typename F>
PlotAxis axisAround(const std::vector<LinePlotSeries>& series, PlotAxis (*axis)(double, double), const F& values) {
    double low = INFINITY, high = -INFINITY;
    for (const LinePlotSeries& one : series)
        for (const LinePlotPoint& point : one.points)
            for (const double value : values(point)) {
                if (!std::isfinite(value) || value <= 0) continue;
                low = std::min(low, value), high = std::max(high, value);
            }
    return axis(low, high);
}
const auto kXs = [](const LinePlotPoint& point) { return std::array{point.x}; };
const auto kYs = [](const LinePlotPoint& point) { return std::array{point.y, point.low, point.high}; };

bool hasALine(const std::vector<LinePlotSeries>& series) {
    return std::any_of(series.begin(), series.end(), [](const auto& one) { return one.points.size() > 1; });
}

std::string legendOf(const BenchReport& report, const std::vector<LinePlotSeries>& series) {
    std::vector<LegendEntry> entries;
    for (size_t m = 0; m < report.methods.size(); ++m)
        if (std::any_of(series.begin(), series.end(), [&](const auto& one) { return one.label == report.methods[m]; }))
            entries.push_back({report.methods[m], methodColour(m)});
    return plotLegend(entries);
}

LinePlotSeries memorySeries(const BenchReport& report, const std::string& scene, size_t method) {
    LinePlotSeries one{report.methods[method], {}, methodColour(method), PlotMark::Diamond};
    for (const Budget& budget : budgetsOf(report, BudgetUnit::Tasks)) {
        const double megabytes = spreadOver(runsOf(report, scene, one.label, budget), kPeakMegabytes).median;
        if (!(budget.amount > 0 && megabytes > 0)) continue;
        one.points.push_back(
            {budget.amount, megabytes, fmt::format("{}, {}: {:.0f} MB", one.label, budgetName(budget), megabytes)});
    }
    return one;
}

// A logarithmic axis with a tick at each number of tasks.
PlotAxis taskAxis(const std::vector<LinePlotSeries>& series) {
    std::set<double> amounts;
    for (const LinePlotSeries& one : series)
        for (const LinePlotPoint& point : one.points) amounts.insert(point.x);
    return {*amounts.begin(), *amounts.rbegin(), true, {amounts.begin(), amounts.end()}};
}

std::string growthRows(const std::string& scene, const std::vector<LinePlotSeries>& series) {
    std::string rows = fmt::format("<tr><th class=\"block\" colspan=\"4\">{}</th></tr>\n", escapeHtml(scene));
    for (const LinePlotSeries& one : series) {
        const LinePlotPoint &first = one.points.front(), &last = one.points.back();
        const double growth = 100 * (last.y / first.y - 1);
        rows += fmt::format(
            "<tr><th class=\"name\">{}</th><td>{:.0f}<small>{}</small></td><td>{:.0f}<small>{}</small></td>"
            "<td>{}{:.1f}&#8201;%</td></tr>\n",
            escapeHtml(one.label), first.y, budgetName({BudgetUnit::Tasks, first.x}), last.y,
            budgetName({BudgetUnit::Tasks, last.x}), growth < 0 ? "&#8722;" : "+", std::abs(growth));
    }
    return "<tbody class=\"group\">\n" + rows + "</tbody>\n";
}

}  // namespace

std::string errorCurves(const BenchReport& report) {
    std::string html;
    for (const BenchScene& scene : report.scenes) {
        std::string plots;
        std::vector<LinePlotSeries> last;
        for (const Error& error : kErrors) {
            const auto series = errorSeries(report, scene.name, error);
            if (!hasALine(series)) continue;
            plots += linePlotSvg(error.title, "seconds", series, axisAround(series, logarithmicAxis, kXs),
                                 axisAround(series, logarithmicAxis, kYs));
            last = series;
        }
        if (plots.empty()) continue;
        html += fmt::format("<h3>{}</h3>\n{}<div class=\"plots\">\n{}</div>\n", escapeHtml(scene.name),
                            legendOf(report, last), plots);
    }
    return html;
}

std::string memoryCurves(const BenchReport& report) {
    std::string plots, rows;
    std::vector<LinePlotSeries> all;
    for (const BenchScene& scene : report.scenes) {
        std::vector<LinePlotSeries> series;
        for (size_t m = 0; m < report.methods.size(); ++m) {
            LinePlotSeries one = memorySeries(report, scene.name, m);
            if (one.points.size() > 1) series.push_back(std::move(one));
        }
        if (series.empty()) continue;
        plots += linePlotSvg(scene.name + ", peak MB", "tasks", series, taskAxis(series),
                             axisAround(series, linearAxis, kYs));
        rows += growthRows(scene.name, series);
        all.insert(all.end(), series.begin(), series.end());
    }
    if (plots.empty()) return "";
    return legendOf(report, all) + "<div class=\"plots\">\n" + plots +
           "</div>\n<div class=\"wide\"><table>\n<thead><tr><th class=\"name\">peak MB</th><th>fewest</th><th>most</th>"
           "<th>change</th></tr></thead>\n" +
           rows + "</table></div>\n";
}

}  // namespace drc
