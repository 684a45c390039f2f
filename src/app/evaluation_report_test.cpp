#include "app/evaluation_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/evaluation_testing.h"
#include "app/evaluation_text.h"

namespace drc {
namespace {

using Json = nlohmann::json;

class EvaluationReportTest : public EvaluationTest {
  protected:
    EvaluationReportTest()
        : evaluation(run({network("a.safetensors", "equal-area", 1), network("b.safetensors", "latlong", 2)})) {}

    // Scores that are given, not computed: of each method of the group, one value an example, in every measure.
    void give(size_t group, const std::vector<std::vector<double>>& values) {
        for (size_t m = 0; m < values.size(); ++m)
            for (size_t i = 0; i < values[m].size(); ++i) {
                const MapScores same{values[m][i], values[m][i], values[m][i]};
                evaluation.groups[group].methods[m].scores[i] = {same, same};
            }
    }

    Evaluation evaluation;
};

TEST_F(EvaluationReportTest, SummarisesAndComparesMethods) {
    give(0, {{10, 11, 12, 13, 19}, {5, 6, 7, 8, 14}, {1, 2, 3, 4, 15}});
    const EvaluationReport report = makeReport(evaluation);
    const GroupReport& group = report.groups[0];
    ASSERT_EQ(group.methods.size(), 3u);
    EXPECT_EQ(group.methods[0].summary[0].mean, 13);
    EXPECT_EQ(group.methods[1].summary[4].median, 7);
    EXPECT_EQ(group.methods[2].summary[5].q3, 4);
    ASSERT_EQ(group.pairs.size(), 3u);
    EXPECT_EQ(group.pairs[0].first + group.pairs[0].second, "agaussian");
    EXPECT_EQ(group.pairs[1].first + group.pairs[1].second, "anone");
    EXPECT_EQ(group.pairs[2].first + group.pairs[2].second, "gaussiannone");
    EXPECT_NEAR(group.pairs[0].paired[0].better, 0.8, 1e-12);  // L1: the smaller
    EXPECT_NEAR(group.pairs[0].paired[1].better, 0.2, 1e-12);  // SSIM: the larger
    EXPECT_EQ(group.all[0].degreesOfFreedom, 2);
    // Mean ranks 11.4, 7.8 and 4.8 of 15 values: h = 12 / (15 * 16) * 5 * (3.4^2 + 0.2^2 + 3.2^2).
    EXPECT_NEAR(group.all[0].h, 0.25 * (11.56 + 0.04 + 10.24), 1e-9);
    EXPECT_EQ(group.pairs[0].kruskalWallis[3].degreesOfFreedom, 1);
}

TEST_F(EvaluationReportTest, ComparesProjectionsOnTheViewpointsThatBothHave) {
    give(0, {{1, 2, 3, 100, 100}, {1, 1, 1, 100, 100}, {1, 2, 3, 100, 100}});
    give(1, {{2, 3, 1, -100, -100}, {1, 1, 1, -100, -100}, {5, 6, 7, -100, -100}});
    const EvaluationReport report = makeReport(evaluation);
    ASSERT_EQ(report.across.size(), 1u);
    const AcrossReport& across = report.across[0];
    EXPECT_EQ(across.viewpoints, 3u);
    ASSERT_EQ(across.pairs.size(), 3u);
    EXPECT_EQ(across.pairs[0].first + "/" + across.pairs[0].second, "none/none");
    EXPECT_EQ(across.pairs[1].first + "/" + across.pairs[1].second, "gaussian/gaussian");
    EXPECT_EQ(across.pairs[2].first + "/" + across.pairs[2].second, "a/b");
    EXPECT_EQ(across.pairs[2].firstMean[0], 2);
    EXPECT_EQ(across.pairs[2].secondMean[0], 6);
    EXPECT_NEAR(across.pairs[0].paired[0].better, 2.0 / 3, 1e-12);
    EXPECT_EQ(across.pairs[1].paired[0].p, 1);
    EXPECT_EQ(across.pairs[2].paired[0].better, 1);
}

TEST_F(EvaluationReportTest, TableHasEveryMethodAndTest) {
    const std::string table = evaluationTable(evaluation, makeReport(evaluation));
    for (const char* part :
         {"equal-area maps of 32x32 texels, 5 examples of 2 files, one input each", "latlong maps of 32x32",
          "a against gaussian\n", "a against none\n", "b against gaussian\n", "gaussian against none\n",
          "all methods\n  Kruskal-Wallis p ", "equal-area against latlong: 3 viewpoints that both have",
          "a against b\n", "  Wilcoxon p ", "as rendered", "equal energy"})
        EXPECT_NE(table.find(part), std::string::npos) << part;
    EXPECT_EQ(table.find("file skipped"), std::string::npos);
}

TEST_F(EvaluationReportTest, JsonHasWhatTheReportHas) {
    // Beyond what a number holds, and no number at all.
    EvaluationReport report = makeReport(evaluation);
    report.groups[0].all[0].p = 0;
    report.groups[1].methods[2].summary[1].median = NAN;
    const std::string text = evaluationJson(evaluation, report);
    EXPECT_EQ(text.find('\n'), text.size() - 1);
    const Json json = Json::parse(text);
    EXPECT_EQ(json["examples"], 10);
    EXPECT_EQ(json["networks"][0]["name"], "a");
    EXPECT_EQ(json["networks"][1]["metadata"]["projection"], "latlong");
    EXPECT_EQ(json["networks"][0]["content"], UNetWeights::load(path("a.safetensors"))->hash());
    ASSERT_EQ(json["projections"].size(), 2u);
    const Json& group = json["projections"][0];
    EXPECT_EQ(group["projection"], "equal-area");
    EXPECT_EQ(group["files"][1]["scene"], kHostileScene);
    const Summary& summary = report.groups[0].methods[2].summary[5];
    const Json& measure = group["methods"]["a"]["equal_energy"]["irradiance_relmse"];
    EXPECT_EQ(measure["mean"], summary.mean);
    EXPECT_EQ(measure["median"], summary.median);
    EXPECT_EQ(measure["q1"], summary.q1);
    EXPECT_EQ(measure["q3"], summary.q3);
    EXPECT_TRUE(json["projections"][1]["methods"]["b"]["as_rendered"]["ssim"]["median"].is_null());
    const Json& all = group["all_methods"]["kruskal_wallis"];
    EXPECT_EQ(all["as_rendered"]["l1"]["p"], 1e-300);
    EXPECT_EQ(all["as_rendered"]["l1"]["p_is_bound"], true);
    EXPECT_EQ(all["as_rendered"]["ssim"]["p"], report.groups[0].all[1].p);
    EXPECT_FALSE(all["as_rendered"]["ssim"].contains("p_is_bound"));
    ASSERT_EQ(group["comparisons"].size(), 3u);
    EXPECT_EQ(group["comparisons"][0]["equal_energy"]["l1"]["wilcoxon"]["p"], report.groups[0].pairs[0].paired[3].p);
    EXPECT_EQ(group["comparisons"][0]["equal_energy"]["l1"]["first_better"],
              report.groups[0].pairs[0].paired[3].better);
    const Json& across = json["across_projections"][0];
    EXPECT_EQ(across["viewpoints"], 3);
    EXPECT_EQ(across["comparisons"][2]["second"], "b");
    EXPECT_EQ(across["comparisons"][2]["as_rendered"]["l1"]["second_mean"], report.across[0].pairs[2].secondMean[0]);
}

TEST(EvaluationReport, PValuesAsText) {
    EXPECT_EQ(formatP(0.0123), "0.012");
    EXPECT_EQ(formatP(0.5), "0.50");
    EXPECT_EQ(formatP(1e-80), "1.0e-80");
    EXPECT_EQ(formatP(1.3e-82), "1.3e-82");
    EXPECT_EQ(formatP(0), "< 1e-300");
    EXPECT_EQ(formatP(NAN), "nan");
}

}  // namespace
}  // namespace drc
