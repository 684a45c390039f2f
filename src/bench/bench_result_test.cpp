#include "bench/bench_result.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drc {
namespace {

TEST(BenchResult, BudgetsHaveNames) {
    EXPECT_EQ(budgetName({BudgetUnit::Seconds, 2.5}), "2.5 s");
    EXPECT_EQ(budgetName({BudgetUnit::Spp, 16}), "16 spp");
    EXPECT_EQ(budgetName({BudgetUnit::Tasks, 256}), "256 tasks");
    EXPECT_EQ(budgetName({BudgetUnit::Tasks, 1}), "1 task");
}

TEST(BenchResult, FewValuesSpreadOverAllOfThem) {
    const BenchSpread spread = spreadOf({3, 1, kNotMeasured, 2, 7});
    EXPECT_EQ(spread.count, 4);
    EXPECT_EQ(spread.median, 2.5);
    EXPECT_EQ(spread.low, 1);
    EXPECT_EQ(spread.high, 7);
    EXPECT_EQ(spreadOf({4}).low, 4);
    EXPECT_EQ(spreadOf({}).count, 0);
    EXPECT_TRUE(std::isnan(spreadOf({kNotMeasured}).median));
}

// Ranks of the 95 % interval of the median, as tables of the sign test have them.
TEST(BenchResult, ManyValuesHaveTheIntervalOfTheSignTest) {
    const auto interval = [](int n) {
        std::vector<double> values;
        for (int i = n; i >= 1; --i) values.push_back(i);
        const BenchSpread spread = spreadOf(values);
        return std::pair(spread.low, spread.high);
    };
    EXPECT_EQ(interval(6), std::pair(1., 6.));
    EXPECT_EQ(interval(8), std::pair(1., 8.));
    EXPECT_EQ(interval(9), std::pair(2., 8.));
    EXPECT_EQ(interval(12), std::pair(3., 10.));
    EXPECT_EQ(interval(25), std::pair(8., 18.));
}

TEST(BenchResult, RunsThatFailedAreNoneOfTheRuns) {
    BenchReport report;
    report.runs.resize(3);
    for (BenchRun& run : report.runs) run.scene = "s", run.method = "m", run.budget = {BudgetUnit::Spp, 4};
    report.runs[1].failure = "no";
    report.runs[2].budget.amount = 8;
    EXPECT_EQ(runsOf(report, "s", "m", {BudgetUnit::Spp, 4}).size(), 1u);
    EXPECT_EQ(runsOf(report, "s", "m", {BudgetUnit::Tasks, 4}).size(), 0u);
}

TEST(BenchResult, TheOpponentIsPathTracingWithTheBestModeOfOpenImageDenoise) {
    BenchReport report;
    const Budget budget{BudgetUnit::Seconds, 4};
    EXPECT_TRUE(std::isnan(opponentError(report, "s", budget)));
    report.methods = {"drc", "path+oidn", "path+oidn:fast-raw", "path+oidn:high", "path+oidn2"};
    for (const auto& [method, error] :
         {std::pair("drc", .1), {"path+oidn", .5}, {"path+oidn", .7}, {"path+oidn:fast-raw", .4}, {"path+oidn2", .2}}) {
        BenchRun run;
        run.scene = "s", run.method = method, run.budget = budget, run.error = error;
        report.runs.push_back(run);
    }
    EXPECT_EQ(opponentError(report, "s", budget), .4);
    report.methods.erase(report.methods.begin() + 2);
    EXPECT_EQ(opponentError(report, "s", budget), .6);  // the median of its repeats
    EXPECT_TRUE(std::isnan(opponentError(report, "other", budget)));
    for (BenchRun& run : report.runs) run.error = -1e-6;
    EXPECT_TRUE(std::isnan(opponentError(report, "s", budget)));
}

}  // namespace
}  // namespace drc
