// Line plots as inline SVG, in the colours of html_page.h.
#pragma once
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "report/plot_axis.h"

namespace drc {

enum class PlotMark { Circle, Square, Diamond };

struct LinePlotPoint {
    double x = 0, y = 0;
    std::string title;  // shown where the pointer rests on it
    // The ends of a bar for what is uncertain of y; NaN: no bar.
    double low = std::numeric_limits<double>::quiet_NaN(), high = std::numeric_limits<double>::quiet_NaN();
};

// Points joined in their order.
struct LinePlotSeries {
    std::string label;
    std::vector<LinePlotPoint> points;
    int colour = 0;  // of the page's series
    PlotMark mark = PlotMark::Circle;
};

// The drawing is 360 by 250 units; kLinePlotArea says where in it the axes end.
struct LinePlotArea {
    double left, right, top, bottom;
};
inline constexpr LinePlotArea kLinePlotArea{46, 350, 24, 210};

// What an axis cannot show is left out: NaN and, on a logarithmic one, what is not positive.
std::string linePlotSvg(const std::string& title, const std::string& xLabel, std::span<const LinePlotSeries> series,
                        const PlotAxis& xAxis, const PlotAxis& yAxis);

// A mark and a name a series, for below plots that share them.
struct LegendEntry {
    std::string label;
    int colour = 0;
};
std::string plotLegend(std::span<const LegendEntry> entries);

}  // namespace drc
