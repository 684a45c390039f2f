#include "bench/page_paper_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/page_testing.h"
#include "report/html_testing.h"

namespace drc {
namespace {

class PagePaperTableTest : public testing::Test {
  protected:
    void add(const std::string& method, const Budget& budget, double time, double ssim, double pngKb) {
        BenchRun& run = b.add("box", method, budget, 0.1, ssim);
        run.seconds = time, run.pngKb = pngKb;
    }
    void addAll() {
        add("drc-maps", tasks(1), 2, 0.7, 50.5);
        add("drc-maps", tasks(16), 10, 0.93, 40.5);
        add("drc-maps", tasks(256), 90, 0.96, 30.5);
        add("bdpt", spp(1), 1, 0.3, 90.5);
        add("bdpt", spp(16), 20, 0.6, 80.5);
        add("bdpt", spp(64), 80, 0.84, 70.5);
    }

    ReportBuilder b;
};

TEST_F(PagePaperTableTest, HasARowAnAmountAndAllMethodsBesideEachOther) {
    addAll();
    b.report.scenes[0].referencePngKb = 12.34, b.report.scenes[0].referenceEntropy = 6.789;
    const std::string html = paperTables(b.report);
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_NE(html.find("a PNG of 12.3 KB, entropy 6.79 bits"), std::string::npos);
    EXPECT_NE(html.find(">drc-maps, tasks</th>"), std::string::npos);
    EXPECT_NE(html.find(">bdpt, spp</th>"), std::string::npos);
    EXPECT_NE(html.find("<tr><th>16</th><td class=\"gap\">10.00</td><td>0.9300</td><td>40.5</td>"
                        "<td class=\"gap\">20.00</td><td>0.6000</td><td>80.5</td></tr>"),
              std::string::npos);
    // What was not run is blank.
    EXPECT_NE(html.find("<tr><th>256</th><td class=\"gap\">90.00</td><td>0.9600</td><td>30.5</td>"
                        "<td class=\"gap\"></td><td></td><td></td></tr>"),
              std::string::npos);
}

TEST_F(PagePaperTableTest, StandsBesideThePaper) {
    addAll();
    add("path", spp(1), 1, 0.2, 90.5);
    add("path", spp(16), 9, 0.5, 90.5);  // not as long as 16 tasks took
    const std::string rows = between(paperTables(b.report), "the paper: DRC", "</table>");
    EXPECT_EQ(rows.find("path"), std::string::npos);
    EXPECT_NE(rows.find("0.89</td><td>0.91</td><td class=\"gap\">0.82</td><td>0.90</td>"), std::string::npos);
    // After 10 s: 0.3 + 0.3 log(10) / log(20); after 40 s half way from 0.6 to 0.84.
    EXPECT_NE(rows.find("drc-maps &#183; bdpt</th><td class=\"gap\">0.93</td><td>0.96<small>at 256 tasks</small></td>"
                        "<td class=\"gap\">0.53</td><td>0.72</td>"),
              std::string::npos)
        << rows;
}

TEST_F(PagePaperTableTest, SsimBetweenRunsIsLinearInTheLogarithmOfTime) {
    addAll();
    const auto after = [&](double time) { return ssimAfter(b.report, "box", "bdpt", BudgetUnit::Spp, time); };
    EXPECT_NEAR(after(20), 0.6, 1e-12);
    EXPECT_NEAR(after(40), 0.72, 1e-12);
    EXPECT_NEAR(after(std::sqrt(20.)), 0.45, 1e-12);
    EXPECT_TRUE(std::isnan(after(0.9)));
    EXPECT_TRUE(std::isnan(after(81)));
    EXPECT_TRUE(std::isnan(after(kNotMeasured)));
}

TEST_F(PagePaperTableTest, WhatIsUnknownIsADash) {
    add("drc-maps", tasks(1), 2, kNotMeasured, kNotMeasured);
    add("bdpt", spp(1), 1, 0.3, 90.5);
    const std::string html = paperTables(b.report);
    EXPECT_EQ(html.find("nan"), std::string::npos);
    EXPECT_NE(html.find("<td>&#8211;</td>"), std::string::npos);
}

TEST_F(PagePaperTableTest, FailuresStandWhereTheNumbersWould) {
    addAll();
    b.addFailure("box", "drc-maps", tasks(4), "out & over");
    const std::string html = paperTables(b.report);
    EXPECT_NE(html.find("<tr><th>4</th><td class=\"text failure gap\" colspan=\"3\">out &amp; over</td>"),
              std::string::npos);
}

TEST_F(PagePaperTableTest, ScenesWithoutTasksOrSamplesAreLeftOut) {
    b.add("hall", "drc-maps", seconds(2), 0.1);
    EXPECT_EQ(paperTables(b.report), "");
    addAll();
    const std::string html = paperTables(b.report);
    EXPECT_EQ(html.find("hall"), std::string::npos);
    EXPECT_EQ(occurrences(html, "<h3>"), 1);
}

}  // namespace
}  // namespace drc
