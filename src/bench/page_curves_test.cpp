#include "bench/page_curves.h"

#include <gtest/gtest.h>

#include "bench/page_testing.h"
#include "report/html_testing.h"

namespace drc {
namespace {

TEST(PageCurves, PointsAreErrorAgainstSecondsOfTheProcess) {
    ReportBuilder b;
    b.add("box", "drc", seconds(1), 1, 0);
    b.add("box", "drc", seconds(10), 0.1, 0.9);
    b.add("box", "drc", seconds(100), 0.01, 0.99);
    const std::string html = errorCurves(b.report);
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_EQ(occurrences(html, "<svg "), 3);
    // All three fall from corner to corner: the error and 1 - SSIM from 1 to 0.01, FLIP from 0.5 to 0.005.
    EXPECT_EQ(occurrences(html, "d=\"M46.0 24.0L198.0 117.0L350.0 210.0\""), 3);
    EXPECT_NE(html.find("<title>drc, 10 s: error 0.1 in 10.00 s</title>"), std::string::npos);
    EXPECT_NE(html.find("1 \u2212 SSIM 0.1 in 10.00 s</title>"), std::string::npos);
}

TEST(PageCurves, EachUnitHasALineAndAMark) {
    ReportBuilder b;
    for (const double n : {1., 4.}) {
        b.add("box", "a", seconds(n), 1 / n);
        b.add("box", "a", tasks(n), 1 / n).seconds = n;
        b.add("box", "b", spp(n), 1 / n).seconds = n;
    }
    const std::string plot = between(errorCurves(b.report), "<svg ", "</svg>");
    EXPECT_EQ(occurrences(plot, "class=\"line\""), 3);
    EXPECT_EQ(occurrences(plot, "<circle"), 2);
    EXPECT_EQ(occurrences(plot, "<path class=\"mark\""), 4);
    EXPECT_EQ(occurrences(errorCurves(b.report), "<i></i>"), 2);  // names in the legend
}

TEST(PageCurves, RepeatsAreOnePointWithABar) {
    ReportBuilder b;
    for (const double error : {0.1, 0.2, 0.4}) b.add("box", "a", seconds(1), error);
    b.add("box", "a", seconds(5), 0.05);
    const std::string plot = between(errorCurves(b.report), "<svg ", "</svg>");
    EXPECT_EQ(occurrences(plot, "<circle"), 2);
    EXPECT_EQ(occurrences(plot, "class=\"whisker\""), 1);
    EXPECT_NE(plot.find("error 0.2 in"), std::string::npos);
}

TEST(PageCurves, NoLineNoPlot) {
    ReportBuilder b;
    b.add("box", "a", seconds(1), 0.1);
    b.add("box", "b", seconds(1), 0.2);
    EXPECT_EQ(errorCurves(b.report), "");
    // Without SSIM the other two are left.
    b.report.runs[0].ssim = kNotMeasured;
    b.add("box", "a", seconds(2), 0.05, kNotMeasured);
    EXPECT_EQ(occurrences(errorCurves(b.report), "<svg "), 2);
    EXPECT_EQ(errorCurves(b.report).find("nan"), std::string::npos);
}

TEST(PageCurves, MemoryStandsOverTasks) {
    ReportBuilder b;
    b.add("<box>", "drc-maps", tasks(1), 0.1).peakMegabytes = 200;
    b.add("<box>", "drc-maps", tasks(4), 0.1).peakMegabytes = 210;
    b.add("<box>", "drc-maps", tasks(16), 0.1).peakMegabytes = 250;
    b.add("<box>", "path", seconds(2), 0.1);
    const std::string html = memoryCurves(b.report);
    EXPECT_EQ(brokenNesting(html), "");
    // From 0 to 250 MB, and a tick at each number of tasks.
    EXPECT_NE(html.find("d=\"M46.0 61.2L198.0 53.8L350.0 24.0\""), std::string::npos) << html;
    EXPECT_EQ(occurrences(html, ">4</text>"), 1);
    EXPECT_NE(html.find("<td>+25.0&#8201;%</td>"), std::string::npos);
    EXPECT_EQ(html.find(">path<"), std::string::npos);
}

TEST(PageCurves, NoMemoryCurveOfOneNumberOfTasks) {
    ReportBuilder b;
    b.add("box", "drc-maps", tasks(4), 0.1);
    b.add("box", "drc-maps", tasks(8), 0.1).peakMegabytes = kNotMeasured;
    EXPECT_EQ(memoryCurves(b.report), "");
}

}  // namespace
}  // namespace drc
