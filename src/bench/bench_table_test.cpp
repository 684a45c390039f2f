#include "bench/bench_table.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(BenchTable, HasMediansAndFailures) {
    BenchReport report;
    report.methods = {"path", "other"};
    report.budgets = {{BudgetUnit::Seconds, 10}, {BudgetUnit::Spp, 4}};
    report.scenes.resize(1);
    report.scenes[0].name = "room";
    BenchRun run;
    run.scene = "room", run.method = "path", run.budget = report.budgets[0];
    run.seconds = 9.96, run.flip = .05, run.relmse = .012345, run.peakMegabytes = 210.4;
    run.meanRatio = {1, .999, 1.01};
    for (double ssim : {.8, .9, .7}) {
        run.ssim = ssim;
        report.runs.push_back(run);
    }
    run.method = "other", run.failure = "a|b";
    report.runs.push_back(run);
    EXPECT_EQ(benchMarkdown(report),
              "## 10 s\n\n"
              "| scene | method | seconds | SSIM   | FLIP   | relMSE  | mean ratio RGB    | MB  |\n"
              "|-------|--------|---------|--------|--------|---------|-------------------|-----|\n"
              "| room  | path   | 10.0    | 0.8000 | 0.0500 | 0.01235 | 1.000 0.999 1.010 | 210 |\n"
              "| room  | other  | -       |        |        |         |                   |     |\n\n"
              "- room, other: a|b\n\n");
}

}  // namespace
}  // namespace drc
