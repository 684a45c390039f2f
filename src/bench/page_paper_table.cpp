#include "bench/page_paper_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/page_measures.h"
#include "report/html_page.h"

namespace drc {
namespace {

const BenchMeasure* const kColumns[] = {&kSeconds, &kSsim, &kPngKb};
constexpr double kPaperTasks = 16;

// A method as far as its budgets are of one unit.
struct Column {
    std::string method;
    BudgetUnit unit;
};

std::vector<Column> columnsOf(const BenchReport& report, const std::string& scene, BudgetUnit unit) {
    std::vector<Column> columns;
    for (const std::string& method : report.methods)
        for (const Budget& budget : budgetsOf(report, unit))
            if (!runsOf(report, scene, method, budget).empty() || !failuresOf(report, scene, method, budget).empty()) {
                columns.push_back({method, unit});
                break;
            }
    return columns;
}

std::string cells(const BenchReport& report, const std::string& scene, const Column& column, double amount) {
    const Budget budget{column.unit, amount};
    const auto runs = runsOf(report, scene, column.method, budget);
    const auto failures = failuresOf(report, scene, column.method, budget);
    if (runs.empty() && !failures.empty())
        return fmt::format("<td class=\"text failure gap\" colspan=\"{}\">{}</td>", std::size(kColumns),
                           escapeHtml(failures.front()->failure));
    std::string html;
    for (const BenchMeasure* measure : kColumns)
        html += fmt::format("<td{}>{}</td>", html.empty() ? " class=\"gap\"" : "",
                            runs.empty() ? "" : measure->text(spreadOver(runs, *measure).median));
    return html;
}

std::string amountTable(const BenchReport& report, const std::string& scene, const std::vector<Column>& columns) {
    std::string spans, titles;
    std::set<double> amounts;
    for (const Column& column : columns) {
        spans += fmt::format("<th class=\"gap\" colspan=\"{}\">{}, {}</th>", std::size(kColumns),
                             escapeHtml(column.method), column.unit == BudgetUnit::Tasks ? "tasks" : "spp");
        for (const BenchMeasure* measure : kColumns)
            titles += fmt::format("<th{}>{}</th>", measure == kColumns[0] ? " class=\"gap\"" : "", measure->title);
        for (const Budget& budget : budgetsOf(report, column.unit)) amounts.insert(budget.amount);
    }
    std::string rows;
    for (const double amount : amounts) {
        rows += fmt::format("<tr><th>{:g}</th>", amount);
        for (const Column& column : columns) rows += cells(report, scene, column, amount);
        rows += "</tr>\n";
    }
    return fmt::format(
        "<div class=\"wide\"><table>\n<thead><tr class=\"span\"><th></th>{}</tr><tr><th></th>{}</tr>"
        "</thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
        spans, titles, rows);
}

// SSIM of the paper's method and of bidirectional path tracing, above the same pairs of our methods. Pairs without an
// SSIM of the second method at the times compared are left out.
std::string beside(const BenchReport& report, const std::string& scene, const std::vector<Column>& tasks,
                   const std::vector<Column>& samples) {
    std::string rows;
    for (const Column& ours : tasks) {
        const auto atTasks = runsOf(report, scene, ours.method, {BudgetUnit::Tasks, kPaperTasks});
        const double seconds = spreadOver(atTasks, kSeconds).median, ssim = spreadOver(atTasks, kSsim).median;
        double last = kNotMeasured, most = 0;
        for (const Budget& budget : budgetsOf(report, BudgetUnit::Tasks)) {
            const auto runs = runsOf(report, scene, ours.method, budget);
            if (!runs.empty()) last = spreadOver(runs, kSsim).median, most = budget.amount;
        }
        for (const Column& other : samples) {
            const double same = ssimAfter(report, scene, other.method, other.unit, seconds),
                         later = ssimAfter(report, scene, other.method, other.unit, 4 * seconds);
            if (std::isnan(same) && std::isnan(later)) continue;
            rows += fmt::format(
                "<tr><th class=\"name\">{} &#183; {}</th><td class=\"gap\">{}</td><td>{}<small>{}</small></td><td "
                "class=\"gap\">{}</td><td>{}</td></tr>\n",
                escapeHtml(ours.method), escapeHtml(other.method), twoDecimals(ssim), twoDecimals(last),
                most == kPaperTasks ? "" : "at " + budgetName({BudgetUnit::Tasks, most}), twoDecimals(same),
                twoDecimals(later));
        }
    }
    if (rows.empty()) return "";
    return "<div class=\"wide\"><table>\n<thead><tr class=\"span\"><th></th><th class=\"gap\" colspan=\"2\">"
           "SSIM of the first</th><th class=\"gap\" colspan=\"2\">of the second</th></tr>\n<tr><th></th>"
           "<th class=\"gap\">16 tasks</th><th>most tasks</th><th class=\"gap\">time of 16 tasks</th>"
           "<th>four times that</th></tr></thead>\n<tbody>\n<tr class=\"soft\"><th class=\"name\">the paper: DRC "
           "&#183; BDPT</th><td class=\"gap\">0.89</td>"
           "<td>0.91</td><td class=\"gap\">0.82</td><td>0.90</td></tr>\n" +
           rows + "</tbody>\n</table></div>\n";
}

}  // namespace

double ssimAfter(const BenchReport& report, const std::string& scene, const std::string& method, BudgetUnit unit,
                 double seconds) {
    std::vector<std::pair<double, double>> points;
    for (const Budget& budget : budgetsOf(report, unit)) {
        const auto runs = runsOf(report, scene, method, budget);
        const double time = spreadOver(runs, kSeconds).median, ssim = spreadOver(runs, kSsim).median;
        if (time > 0 && !std::isnan(ssim)) points.emplace_back(time, ssim);
    }
    std::sort(points.begin(), points.end());
    for (size_t i = 1; i < points.size(); ++i) {
        const auto [t0, s0] = points[i - 1];
        const auto [t1, s1] = points[i];
        if (seconds < t0 || seconds > t1 || !(t1 > t0)) continue;
        return s0 + (s1 - s0) * std::log(seconds / t0) / std::log(t1 / t0);
    }
    return kNotMeasured;
}

std::string paperTables(const BenchReport& report) {
    std::string html;
    for (const BenchScene& scene : report.scenes) {
        const auto tasks = columnsOf(report, scene.name, BudgetUnit::Tasks),
                   samples = columnsOf(report, scene.name, BudgetUnit::Spp);
        std::vector<Column> columns = tasks;
        columns.insert(columns.end(), samples.begin(), samples.end());
        if (columns.empty()) continue;
        html +=
            fmt::format("<h3>{}</h3>\n<p class=\"note\">The reference: a PNG of {} KB, entropy {} bits a pixel.</p>\n",
                        escapeHtml(scene.name), oneDecimal(scene.referencePngKb), twoDecimals(scene.referenceEntropy));
        html += amountTable(report, scene.name, columns) + beside(report, scene.name, tasks, samples);
    }
    return html;
}

}  // namespace drc
