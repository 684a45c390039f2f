#include "app/evaluation_page_tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/html_page.h"

namespace drc {
namespace {

constexpr const char* kTableEnd = "</table></div>\n";

// The beginning of a table with one column for each measure.
std::string tableHead() {
    std::string spans, titles;
    for (size_t m = 0; m < kMeasureCount; ++m) {
        const bool begins = m == 0 || std::string(kMeasures[m].group) != kMeasures[m - 1].group;
        if (begins)
            spans += fmt::format(
                "<th colspan=\"{}\" class=\"gap\">{}</th>",
                std::count_if(kMeasures.begin(), kMeasures.end(),
                              [&](const Measure& other) { return std::string(other.group) == kMeasures[m].group; }),
                kMeasures[m].groupTitle);
        titles += fmt::format("<th{}>{} {}</th>", begins ? " class=\"gap\"" : "", kMeasures[m].title,
                              kMeasures[m].higherIsBetter ? "&#8593;" : "&#8595;");
    }
    return fmt::format(
        "<div class=\"wide\"><table class=\"measures\">\n<thead><tr "
        "class=\"span\"><th></th>{}</tr><tr><th></th>{}</tr></thead>\n",
        spans, titles);
}

// cell(m): the content of the cell; best(m): whether it is bold.
template <typename F, typename G>
std::string row(const std::string& name, const F& cell, const G& best) {
    std::string html = fmt::format("<tr><th class=\"name\">{}</th>", escapeHtml(name));
    for (size_t m = 0; m < kMeasureCount; ++m) {
        const char* style = best(m) ? " class=\"best\"" : "";
        html += fmt::format("<td{}>{}</td>", style, cell(m));
    }
    return html + "</tr>\n";
}
template <typename F>
std::string row(const std::string& name, const F& cell) {
    return row(name, cell, [](size_t) { return false; });
}

std::string block(const std::string& title, const std::string& rows) {
    return fmt::format("<tbody class=\"group\">\n<tr><th class=\"block\" colspan=\"{}\">{}</th></tr>\n{}</tbody>\n",
                       kMeasureCount + 1, escapeHtml(title), rows);
}

std::string testRows(const PairReport& pair) {
    return row("better in",
               [&](size_t m) {
                   const double better = pair.paired[m].better;
                   return std::isnan(better) ? htmlNumber(better) : fmt::format("{:.1f} %", 100 * better);
               }) +
           row("Wilcoxon p", [&](size_t m) { return htmlP(pair.paired[m].p); }) +
           row("Kruskal\u2013Wallis p", [&](size_t m) { return htmlP(pair.kruskalWallis[m].p); });
}

}  // namespace

std::string scoreTable(const GroupReport& group) {
    const auto rows = [&](double Summary::*part) {
        std::string html;
        for (const MethodReport& method : group.methods)
            html += row(
                method.name, [&](size_t m) { return htmlNumber(method.summary[m].*part); },
                [&](size_t m) {
                    const double sign = kMeasures[m].higherIsBetter ? -1 : 1, own = method.summary[m].*part;
                    return std::all_of(group.methods.begin(), group.methods.end(), [&](const MethodReport& other) {
                        return sign * own <= sign * (other.summary[m].*part);
                    });
                });
        return html;
    };
    std::string quartiles;
    for (const MethodReport& method : group.methods)
        quartiles += row(method.name, [&](size_t m) {
            return htmlNumber(method.summary[m].q1) + " &#8211; " + htmlNumber(method.summary[m].q3);
        });
    return tableHead() + block("Mean", rows(&Summary::mean)) + block("Median", rows(&Summary::median)) +
           block("Quartiles", quartiles) + kTableEnd;
}

std::string testTable(const GroupReport& group) {
    std::string html =
        tableHead() +
        block("All methods together", row("Kruskal\u2013Wallis p", [&](size_t m) { return htmlP(group.all[m].p); }));
    for (const PairReport& pair : group.pairs) html += block(pair.first + " against " + pair.second, testRows(pair));
    return html + kTableEnd;
}

std::string acrossTable(const AcrossReport& across, const std::string& firstGroup, const std::string& secondGroup) {
    std::string html = tableHead();
    for (const PairReport& pair : across.pairs) {
        const auto isBest = [](const PerMeasure<double>& own, const PerMeasure<double>& other) {
            return [&](size_t m) { return kMeasures[m].higherIsBetter ? own[m] >= other[m] : own[m] <= other[m]; };
        };
        html += block(pair.first == pair.second ? pair.first : pair.first + " against " + pair.second,
                      row(
                          "mean, " + firstGroup, [&](size_t m) { return htmlNumber(pair.firstMean[m]); },
                          isBest(pair.firstMean, pair.secondMean)) +
                          row(
                              "mean, " + secondGroup, [&](size_t m) { return htmlNumber(pair.secondMean[m]); },
                              isBest(pair.secondMean, pair.firstMean)) +
                          testRows(pair));
    }
    return html + kTableEnd;
}

}  // namespace drc
