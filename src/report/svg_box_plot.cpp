#include "report/svg_box_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/html_page.h"

namespace drc {
namespace {

constexpr double kWidth = 360, kTop = 24, kRow = 24, kBox = 12, kFoot = 18, kRight = 12;
constexpr size_t kLabelLetters = 18;
constexpr double kLetter = 6.1;

// Truncated between UTF-8 characters.
std::string shortened(const std::string& text) {
    size_t letters = 0, end = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        if ((uint8_t(text[i]) & 0xc0) == 0x80) continue;
        if (letters++ == kLabelLetters - 1) end = i;
    }
    return letters > kLabelLetters ? text.substr(0, end) + "\u2026" : text;
}

size_t letterCount(const std::string& text) {
    return size_t(std::count_if(text.begin(), text.end(), [](char c) { return (uint8_t(c) & 0xc0) != 0x80; }));
}

std::string drawRow(const BoxPlotRow& row, double y, const auto& x) {
    const Summary& s = row.summary;
    if (std::isnan(s.median)) return "";
    const double top = y - kBox / 2, whisker = kBox / 4;
    std::string svg =
        fmt::format("<g class=\"c{}\"><title>{}: median {:.4g}, quartiles {:.4g} and {:.4g}, mean {:.4g}</title>",
                    row.colour, escapeHtml(row.label), s.median, s.q1, s.q3, s.mean);
    svg += fmt::format("<path class=\"whisker\" d=\"M{0:.1f} {2:.1f}V{3:.1f}M{0:.1f} {4:.1f}H{1:.1f}\"/>", x(s.p5),
                       x(s.q1), y - whisker, y + whisker, y);
    svg += fmt::format("<path class=\"whisker\" d=\"M{0:.1f} {2:.1f}V{3:.1f}M{0:.1f} {4:.1f}H{1:.1f}\"/>", x(s.p95),
                       x(s.q3), y - whisker, y + whisker, y);
    svg += fmt::format("<rect class=\"box\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>", x(s.q1), top,
                       x(s.q3) - x(s.q1), kBox);
    svg += fmt::format("<path class=\"median\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>", x(s.median), top, top + kBox);
    svg += fmt::format("<circle class=\"mean\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/></g>\n", x(s.mean), y);
    return svg;
}

}  // namespace

PlotAxis axisFor(std::span<const Summary> summaries, bool logarithmic) {
    double low = INFINITY, high = -INFINITY;
    for (const Summary& s : summaries) {
        if (std::isnan(s.median)) continue;
        low = std::min({low, s.p5, s.mean});
        high = std::max({high, s.p95, s.mean});
    }
    if (low > high) return linearAxis(0, 1);
    return logarithmic && low > 0 ? decadeAxis(low, high) : linearAxis(low, high);
}

std::string boxPlotSvg(const std::string& title, std::span<const BoxPlotRow> rows, const PlotAxis& axis) {
    size_t letters = 4;
    for (const BoxPlotRow& row : rows) letters = std::max(letters, std::min(kLabelLetters, letterCount(row.label)));
    const double left = double(letters) * kLetter + 10, bottom = kTop + kRow * double(rows.size());
    const auto x = [&](double value) { return left + axis.place(value) * (kWidth - kRight - left); };
    std::string svg = fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n"
        "<text class=\"title\" x=\"{:.1f}\" y=\"12\">{}</text>\n",
        kWidth, bottom + kFoot, escapeHtml(title), left, escapeHtml(title));
    for (const double tick : axis.ticks)
        svg += fmt::format(
            "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" "
            "text-anchor=\"middle\">{4:.3g}</text>\n",
            x(tick), kTop - 4, bottom, bottom + 13, std::abs(tick) < 1e-12 ? 0 : tick);
    for (size_t i = 0; i < rows.size(); ++i) {
        const double y = kTop + kRow * (double(i) + 0.5);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 10, y + 3.8,
                           escapeHtml(shortened(rows[i].label)));
        svg += drawRow(rows[i], y, x);
    }
    return svg + "</svg>\n";
}

}  // namespace drc
