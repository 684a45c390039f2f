#include "bench/page_equal_time.h"

#include <gtest/gtest.h>

#include "bench/page_testing.h"
#include "report/html_testing.h"

namespace drc {
namespace {

TEST(PageEqualTime, HasATableABudgetAndABlockAScene) {
    ReportBuilder b;
    for (const double amount : {30., 2.})
        for (const char* scene : {"box", "hall"})
            for (const char* method : {"drc", "path"}) b.add(scene, method, seconds(amount), 0.1);
    b.add("box", "drc-maps", tasks(4), 0.1);
    const std::string html = equalTimeTables(b.report);
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_EQ(occurrences(html, "<table"), 2);
    EXPECT_EQ(occurrences(html, ">box</th>"), 2);
    EXPECT_EQ(occurrences(html, ">hall</th>"), 2);
    EXPECT_LT(html.find("<h3>2 s</h3>"), html.find("<h3>30 s</h3>"));
    EXPECT_EQ(html.find("tasks"), std::string::npos);
}

TEST(PageEqualTime, BestOfAScene) {
    ReportBuilder b;
    b.add("box", "a", seconds(2), 0.2, 0.9);
    b.add("box", "b", seconds(2), 0.1, 0.8);
    b.add("box", "c", seconds(2), 0.4, 0.9);
    const std::string html = equalTimeTables(b.report);
    EXPECT_EQ(occurrences(html, "<td class=\"best\">0.9000</td>"), 2);  // SSIM of a and c
    EXPECT_EQ(occurrences(html, "<td class=\"best\">0.0500</td>"), 1);  // FLIP of b
    EXPECT_EQ(occurrences(html, "<td class=\"best\">0.100</td>"), 1);   // the error of b
    EXPECT_EQ(occurrences(html, "\"best\""), 4);
}

// What is within the errors is not the best.
TEST(PageEqualTime, TheBestIsBetterByMoreThanItsError) {
    const auto bold = [](double a, double b, double standardError) {
        ReportBuilder builder;
        for (const auto& [method, error] : {std::pair{"a", a}, {"b", b}}) {
            BenchRun& run = builder.add("box", method, seconds(2), error, 0.9);
            run.errorSe = run.trimmedErrorSe = run.blockErrorSe = standardError;
        }
        return occurrences(equalTimeTables(builder.report), "<td class=\"best\">0.100<small>");
    };
    EXPECT_EQ(bold(0.10, 0.12, 0.001), 1);
    EXPECT_EQ(bold(0.10, 0.12, 0.015), 0);  // 0.021 of both together
    EXPECT_EQ(bold(0.10, 0.12, 0.013), 1);
}

TEST(PageEqualTime, TheBestOfRepeatsHasAnIntervalOfItsOwn) {
    const auto bold = [](double lowest) {
        ReportBuilder b;
        for (const double error : {0.09, 0.10, 0.11}) b.add("box", "a", seconds(2), error, 0.5);
        for (const double error : {lowest, 0.20, 0.25}) b.add("box", "b", seconds(2), error, 0.5);
        return occurrences(equalTimeTables(b.report), "<td class=\"best\">0.100");
    };
    EXPECT_EQ(bold(0.15), 1);
    EXPECT_EQ(bold(0.105), 0);
}

TEST(PageEqualTime, OneMethodIsNotTheBest) {
    ReportBuilder b;
    b.add("box", "a", seconds(2), 0.2);
    b.add("box", "b", seconds(2), kNotMeasured, kNotMeasured);
    const std::string html = equalTimeTables(b.report);
    EXPECT_EQ(occurrences(html, "\"best\""), 0);
    EXPECT_EQ(html.find("nan"), std::string::npos);
    EXPECT_EQ(occurrences(html, "<th class=\"name\">b</th><td>&#8211;</td><td>&#8211;</td>"), 1);
}

TEST(PageEqualTime, RepeatsHaveAMedianAndAnInterval) {
    ReportBuilder b;
    for (const double error : {0.3, 0.1, 0.2}) b.add("box", "a", seconds(2), error, 1 - error);
    b.add("box", "b", seconds(2), 0.25, 0.25);
    const std::string html = equalTimeTables(b.report);
    EXPECT_NE(html.find("0.8000<small>0.7000&#8202;&#8211;&#8202;0.9000</small>"), std::string::npos);
    EXPECT_NE(html.find("0.200<small>0.100&#8202;&#8211;&#8202;0.300</small>"), std::string::npos);
    EXPECT_NE(html.find("<td>0.2500</td>"), std::string::npos);
    EXPECT_EQ(occurrences(html, "<small>"), 3);
}

TEST(PageEqualTime, StandardErrorsAreThere) {
    ReportBuilder b;
    b.add("box", "a", seconds(2), 0.3).errorSe = 0.01;
    EXPECT_NE(equalTimeTables(b.report).find("<td>0.300<small>&#177;&#8202;0.0100</small></td>"), std::string::npos);
    b.add("box", "a", seconds(2), 0.1).errorSe = 0.03;
    EXPECT_NE(equalTimeTables(b.report).find(
                  "<td>0.200<small>&#177;&#8202;0.0200; 0.100&#8202;&#8211;&#8202;0.300</small></td>"),
              std::string::npos);
}

TEST(PageEqualTime, DisplayedMetricsThatAreMostlyNoiseAreMarked) {
    ReportBuilder b;
    b.add("box", "a", seconds(2), 0.2, 0.9);
    b.add("box", "b", seconds(2), 0.2, 0.99);
    b.report.scenes[0].ssimNoise = 0.01;
    const std::string html = equalTimeTables(b.report);
    EXPECT_NE(html.find("<td>0.9000</td>"), std::string::npos);
    EXPECT_NE(html.find(">~0.9900</td>"), std::string::npos);
    EXPECT_EQ(occurrences(html, "~"), 1);
}

TEST(PageEqualTime, TimeAndMemoryArePresent) {
    ReportBuilder b;
    BenchRun& run = b.add("box", "a", seconds(2), 0.2);
    run.seconds = 1.987, run.cpuSeconds = 3.94, run.peakMegabytes = 1234.4;
    run.spp = 17, run.loadSeconds = .25, run.renderSeconds = 1.1, run.denoiseSeconds = 0.5, run.writeSeconds = .125;
    const std::string html = equalTimeTables(b.report);
    EXPECT_NE(html.find("<td>17</td><td>0.25</td><td>1.10</td><td>0.50</td><td>0.12</td><td>1.99</td><td>3.9</td>"
                        "<td>1234</td>"),
              std::string::npos);
}

TEST(PageEqualTime, FailuresSayWhy) {
    ReportBuilder b;
    b.add("box", "a", seconds(2), 0.2);
    b.addFailure("box", "a", seconds(2), "no memory");
    b.addFailure("box", "b", seconds(2), "killed <9>");
    const std::string html = equalTimeTables(b.report);
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_NE(html.find(">1 of 2 failed: no memory</td>"), std::string::npos);
    EXPECT_NE(html.find("<th class=\"name\">b</th><td class=\"text failure\" colspan=\"14\">killed &lt;9&gt;</td>"),
              std::string::npos);
}

std::string meanRow(const std::string& name, const std::string& ratio, const std::string& scenes) {
    return ">" + name + "</th><td>" + ratio + "&#8201;&#215;</td><td class=\"text soft\" colspan=\"13\">" + scenes +
           "<";
}

// Over the scenes that both have: ratios of 2 and 8 in two, none in the third.
TEST(PageEqualTime, GeometricMeansAreRelativeToTheFirstMethod) {
    ReportBuilder b;
    b.add("box", "base", seconds(2), 0.1);
    b.add("box", "other", seconds(2), 0.2);
    b.add("hall", "base", seconds(2), 0.01);
    b.add("hall", "other", seconds(2), 0.08);
    b.add("yard", "base", seconds(2), 0.3);
    b.addFailure("yard", "other", seconds(2), "no");
    const std::string means = between(equalTimeTables(b.report), "that of base, geometric mean", "</table>");
    EXPECT_NE(means.find(meanRow("base", "1.00", "3 scenes")), std::string::npos) << means;
    EXPECT_NE(means.find(meanRow("other", "4.00", "2 scenes")), std::string::npos) << means;
}

TEST(PageEqualTime, PathTracingWithOpenImageDenoiseIsWhatOthersAreMeasuredBy) {
    ReportBuilder b;
    b.add("box", "drc", seconds(2), 0.1);
    b.add("box", "path+oidn", seconds(2), 0.4);
    b.add("box", "path+oidn:fast-raw", seconds(2), 0.2);  // the better one
    const std::string html = equalTimeTables(b.report), means = between(html, "that of the best path+oidn", "</table>");
    EXPECT_NE(html.find(">0.100</td><td>0.50</td>"), std::string::npos);
    EXPECT_NE(html.find(">0.400</td><td>2.00</td>"), std::string::npos);
    EXPECT_NE(means.find(meanRow("drc", "0.500", "1 scene")), std::string::npos) << means;
    EXPECT_NE(means.find(meanRow("path+oidn:fast-raw", "1.00", "1 scene")), std::string::npos) << means;
}

TEST(PageEqualTime, NoMeansWithoutTheFirstMethod) {
    ReportBuilder b;
    b.addFailure("box", "base", seconds(2), "no");
    b.add("box", "other", seconds(2), 0.2);
    EXPECT_EQ(equalTimeTables(b.report).find("geometric"), std::string::npos);
}

TEST(PageEqualTime, NothingWithoutSeconds) {
    ReportBuilder b;
    b.add("box", "a", tasks(2), 0.2);
    EXPECT_EQ(equalTimeTables(b.report), "");
}

}  // namespace
}  // namespace drc
