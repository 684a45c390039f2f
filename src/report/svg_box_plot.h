// Box plots as inline SVG, one row per series, in the colours of html_page.h.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "math/rank_statistics.h"
#include "report/plot_axis.h"

namespace drc {

// The axis that shows all summaries from their 5th to their 95th percentile, with round ends. A linear axis begins at
// zero if no value is far below zero. A logarithmic axis is only used if all values are positive, otherwise a linear
// one. NaN are ignored.
PlotAxis axisFor(std::span<const Summary> summaries, bool logarithmic);

struct BoxPlotRow {
    std::string label;
    Summary summary;
    int colour = 0;  // index of the page's series colours
};

// Boxes span the quartiles, with a line at the median and a circle at the mean; whiskers reach from the 5th to the 95th
// percentile. A row of NaN has no box. The drawing is 360 units wide.
std::string boxPlotSvg(const std::string& title, std::span<const BoxPlotRow> rows, const PlotAxis& axis);

}  // namespace drc
