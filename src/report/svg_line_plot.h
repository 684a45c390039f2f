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
    std::string title;  // tooltip
    // Ends of the error bar; NaN for none.
    double low = std::numeric_limits<double>::quiet_NaN(), high = std::numeric_limits<double>::quiet_NaN();
};

// Points joined by lines in the given order.
struct LinePlotSeries {
    std::string label;
    std::vector<LinePlotPoint> points;
    int colour = 0;  // index of the page's series colours
    PlotMark mark = PlotMark::Circle;
};

// The rectangle within the drawing that the axes enclose. The drawing is 360 by 250 units.
struct LinePlotArea {
    double left, right, top, bottom;
};
inline constexpr LinePlotArea kLinePlotArea{46, 350, 24, 210};

// Values that an axis cannot show are left out: NaN and, on a logarithmic axis, values that are not positive.
std::string linePlotSvg(const std::string& title, const std::string& xLabel, std::span<const LinePlotSeries> series,
                        const PlotAxis& xAxis, const PlotAxis& yAxis);

// A legend entry, for plots below each other that share their series.
struct LegendEntry {
    std::string label;
    int colour = 0;
};
std::string plotLegend(std::span<const LegendEntry> entries);

}  // namespace drc
