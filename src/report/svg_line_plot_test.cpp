#include "report/svg_line_plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/html_testing.h"

namespace drc {
namespace {

const PlotAxis kSeconds{1, 100, true, {1, 10, 100}}, kError{0.01, 1, true, {0.01, 0.1, 1}};

// The plot area is 304 units wide from x = 46 and 186 high above y = 210.
TEST(SvgLinePlot, PointsStandWhereTheAxesHaveTheirValues) {
    const std::vector<LinePlotSeries> series{{"a", {{1, 1, "first"}, {10, 0.1, "second"}, {100, 0.01, "third"}}, 3}};
    const std::string svg = linePlotSvg("error", "s", series, kSeconds, kError);
    EXPECT_EQ(brokenNesting(svg), "");
    EXPECT_NE(svg.find("<g class=\"c3\"><path class=\"line\" d=\"M46.0 24.0L198.0 117.0L350.0 210.0\"/>"),
              std::string::npos);
    EXPECT_NE(svg.find("cx=\"198.0\" cy=\"117.0\" r=\"2.9\"><title>second</title>"), std::string::npos);
    EXPECT_EQ(occurrences(svg, "<circle"), 3);
}

TEST(SvgLinePlot, LeavesOutWhatAnAxisCannotShow) {
    const std::vector<LinePlotSeries> series{{"a", {{1, NAN, ""}, {10, 0, ""}, {0, 1, ""}, {10, 0.1, ""}}},
                                             {"b", {{NAN, NAN, ""}}}};
    const std::string svg = linePlotSvg("", "", series, kSeconds, kError);
    EXPECT_EQ(occurrences(svg, "<circle"), 1);
    EXPECT_EQ(occurrences(svg, "class=\"line\""), 1);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(SvgLinePlot, BarsReachFromLowToHigh) {
    const std::vector<LinePlotSeries> series{{"a", {{10, 0.1, "", 0.01, 1}, {100, 0.1, ""}}}};
    const std::string svg = linePlotSvg("", "", series, kSeconds, kError);
    EXPECT_NE(svg.find("<path class=\"whisker\" d=\"M198.0 210.0V24.0\"/>"), std::string::npos);
    EXPECT_EQ(occurrences(svg, "whisker"), 1);
}

TEST(SvgLinePlot, MarksAndNamesAreKeptApart) {
    const std::vector<LinePlotSeries> series{{"a", {{10, 0.1, "<x>"}}, 0, PlotMark::Square},
                                             {"b", {{10, 0.1, ""}}, 1, PlotMark::Diamond}};
    const std::string svg = linePlotSvg("a & b", "seconds", series, kSeconds, kError);
    EXPECT_EQ(brokenNesting(svg), "");
    EXPECT_EQ(occurrences(svg, "<circle"), 0);
    EXPECT_NE(svg.find("M195.1 114.1h5.8v5.8h-5.8z"), std::string::npos);
    EXPECT_NE(svg.find("M198.0 113.1l3.9 3.9l-3.9 3.9l-3.9 -3.9z"), std::string::npos);
    EXPECT_NE(svg.find("&lt;x&gt;"), std::string::npos);
    EXPECT_NE(svg.find(">a &amp; b</text>"), std::string::npos);
    EXPECT_NE(svg.find(">seconds</text>"), std::string::npos);
}

TEST(SvgLinePlot, LegendNamesEverySeries) {
    const std::vector<LegendEntry> entries{{"a<b", 2}, {"path", 5}};
    const std::string html = plotLegend(entries);
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_NE(html.find("<span class=\"c2\"><i></i>a&lt;b</span>"), std::string::npos);
    EXPECT_NE(html.find("<span class=\"c5\"><i></i>path</span>"), std::string::npos);
}

}  // namespace
}  // namespace drc
