#include "report/svg_line_plot.h"

#include <fmt/core.h>

#include <cmath>

#include "report/html_page.h"

namespace drc {
namespace {

constexpr double kWidth = 360, kHeight = 250;
constexpr double kMark = 2.9;  // half the width of a marker

bool shows(const PlotAxis& axis, double value) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

std::string drawMark(PlotMark mark, double x, double y) {
    switch (mark) {
        case PlotMark::Circle:
            return fmt::format("<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\">", x, y, kMark);
        case PlotMark::Square:
            return fmt::format("<path class=\"mark\" d=\"M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z\">", x - kMark, y - kMark,
                               2 * kMark, 2 * kMark, -2 * kMark);
        case PlotMark::Diamond:
            break;
    }
    const double half = 1.35 * kMark;
    return fmt::format("<path class=\"mark\" d=\"M{0:.1f} {1:.1f}l{2:.1f} {2:.1f}l{3:.1f} {2:.1f}l{3:.1f} {3:.1f}z\">",
                       x, y - half, half, -half);
}

}  // namespace

std::string linePlotSvg(const std::string& title, const std::string& xLabel, std::span<const LinePlotSeries> series,
                        const PlotAxis& xAxis, const PlotAxis& yAxis) {
    const auto [left, right, top, bottom] = kLinePlotArea;
    const auto x = [&, l = left, r = right](double value) { return l + xAxis.place(value) * (r - l); };
    const auto y = [&, t = top, b = bottom](double value) { return b - yAxis.place(value) * (b - t); };
    std::string svg = fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n"
        "<text class=\"title\" x=\"{}\" y=\"12\">{}</text>\n",
        kWidth, kHeight, escapeHtml(title), left, escapeHtml(title));
    for (const double tick : xAxis.ticks)
        svg += fmt::format(
            "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" "
            "text-anchor=\"middle\">{4}</text>\n",
            x(tick), top, bottom, bottom + 14, tickText(tick));
    for (const double tick : yAxis.ticks)
        svg += fmt::format(
            "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"tick\" x=\"{3}\" y=\"{4:.1f}\" "
            "text-anchor=\"end\">{5}</text>\n",
            left, y(tick), right, left - 6, y(tick) + 3.5, tickText(tick));
    svg += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", right, kHeight - 10,
                       escapeHtml(xLabel));
    for (const LinePlotSeries& one : series) {
        std::string line, marks;
        for (const LinePlotPoint& point : one.points) {
            if (!shows(xAxis, point.x) || !shows(yAxis, point.y)) continue;
            line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x(point.x), y(point.y));
            if (shows(yAxis, point.low) && shows(yAxis, point.high))
                marks += fmt::format("<path class=\"whisker\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", x(point.x), y(point.low),
                                     y(point.high));
            marks += drawMark(one.mark, x(point.x), y(point.y)) + "<title>" + escapeHtml(point.title) + "</title>" +
                     (one.mark == PlotMark::Circle ? "</circle>" : "</path>");
        }
        if (line.empty()) continue;
        svg += fmt::format("<g class=\"c{}\"><path class=\"line\" d=\"{}\"/>{}</g>\n", one.colour, line, marks);
    }
    return svg + "</svg>\n";
}

std::string plotLegend(std::span<const LegendEntry> entries) {
    std::string html = "<p class=\"legend\">";
    for (const LegendEntry& entry : entries)
        html += fmt::format("<span class=\"c{}\"><i></i>{}</span> ", entry.colour, escapeHtml(entry.label));
    return html + "</p>\n";
}

}  // namespace drc
