// Box plots as inline SVG: a row a series, drawn in the colours of html_page.h.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "math/rank_statistics.h"
#include "report/plot_axis.h"

namespace drc {

// The axis that shows all of the summaries from their 5th to their 95th percentile, with round ends; a linear one
// begins at nought if no value is much below it. A logarithmic axis is only given for positive values: else a linear
// one is. NaN are left out.
PlotAxis axisFor(std::span<const Summary> summaries, bool logarithmic);

struct BoxPlotRow {
    std::string label;
    Summary summary;
    int colour = 0;  // of the page's series
};

// Boxes from quartile to quartile with a line at the median and a circle at the mean; whiskers from the 5th to the 95th
// percentile. A row of NaN has no box. The drawing is 360 units wide.
std::string boxPlotSvg(const std::string& title, std::span<const BoxPlotRow> rows, const PlotAxis& axis);

}  // namespace drc
