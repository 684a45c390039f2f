#include "report/svg_box_plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/html_testing.h"

namespace drc {
namespace {

Summary spread(double scale) { return {3.5 * scale, scale, 2 * scale, 3 * scale, 4 * scale, 7 * scale}; }
const Summary kNone{NAN, NAN, NAN, NAN, NAN, NAN};

TEST(SvgBoxPlot, LinearAxesHaveRoundEndsAroundAllValues) {
    const std::vector<Summary> all{spread(0.1), kNone, spread(0.13)};
    const PlotAxis axis = axisFor(all, false);
    EXPECT_EQ(axis.low, 0);
    EXPECT_NEAR(axis.high, 1, 1e-12);
    EXPECT_EQ(axis.ticks.size(), 6u);
    EXPECT_NEAR(axis.place(0.25), 0.25, 1e-12);
    EXPECT_EQ(axis.place(-3), 0);
    EXPECT_EQ(axis.place(3), 1);
    EXPECT_NEAR(axisFor(std::vector<Summary>{{-0.3, -0.7, -0.5, -0.3, -0.2, 0.1}}, false).low, -0.8, 1e-12);
    EXPECT_EQ(axisFor(std::vector<Summary>{{0.3, -0.01, 0.1, 0.3, 0.5, 0.6}}, false).low, 0);
}

TEST(SvgBoxPlot, LogarithmicAxesHaveDecades) {
    const PlotAxis axis = axisFor(std::vector<Summary>{spread(0.002)}, true);
    EXPECT_TRUE(axis.logarithmic);
    EXPECT_NEAR(axis.low, 1e-3, 1e-15);
    EXPECT_NEAR(axis.high, 0.1, 1e-12);
    EXPECT_NEAR(axis.place(0.01), 0.5, 1e-12);
    EXPECT_EQ(axis.place(0), 0);
    EXPECT_FALSE(axisFor(std::vector<Summary>{Summary{}}, true).logarithmic);
}

TEST(SvgBoxPlot, NothingToShowHasAnAxisAllTheSame) {
    EXPECT_EQ(axisFor({}, true).high, 1);
    const std::vector<BoxPlotRow> rows{{"none", kNone, 0}};
    const std::string svg = boxPlotSvg("SSIM", rows, axisFor(std::vector<Summary>{kNone}, false));
    EXPECT_EQ(brokenNesting(svg), "");
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(occurrences(svg, "<rect"), 0);
}

TEST(SvgBoxPlot, DrawsABoxARow) {
    const std::vector<BoxPlotRow> rows{{"a<b", spread(0.1), 0}, {"a name of far more letters", spread(0.05), 3}};
    const std::vector<Summary> all{rows[0].summary, rows[1].summary};
    const std::string svg = boxPlotSvg("L1 & more", rows, axisFor(all, false));
    EXPECT_EQ(brokenNesting(svg), "");
    EXPECT_EQ(occurrences(svg, "<rect class=\"box\""), 2);
    EXPECT_EQ(occurrences(svg, "class=\"c3\""), 1);
    EXPECT_NE(svg.find("L1 &amp; more"), std::string::npos);
    EXPECT_NE(svg.find(">a&lt;b</text>"), std::string::npos);
    EXPECT_NE(svg.find(">a name of far mor\u2026</text>"), std::string::npos);
    EXPECT_NE(svg.find("median 0.3, quartiles 0.2 and 0.4"), std::string::npos);
}

// The ends of the whiskers, the box and the median must be at the axis positions of their values.
TEST(SvgBoxPlot, PlacesFollowTheAxis) {
    const std::vector<BoxPlotRow> rows{{"abcd", spread(1), 0}};
    const std::string svg = boxPlotSvg("", rows, PlotAxis{0, 10, false, {}});
    // The axis runs from 34.4 (after a label of four letters and a gap) to 348.
    EXPECT_NE(svg.find("M65.8 "), std::string::npos);          // 1, the 5th percentile
    EXPECT_NE(svg.find("x=\"97.1\""), std::string::npos);      // 2, the first quartile
    EXPECT_NE(svg.find("width=\"62.7\""), std::string::npos);  // 4 - 2
    EXPECT_NE(svg.find("class=\"median\" d=\"M128.5"), std::string::npos);
    EXPECT_NE(svg.find("M253.9 "), std::string::npos);  // 7
}

}  // namespace
}  // namespace drc
