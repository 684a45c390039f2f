#include "bench/bench_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace drc {
namespace {

BenchRun someRun() {
    BenchRun run;
    run.scene = "room", run.method = "drc-maps:gaussian+oidn";
    run.budget = {BudgetUnit::Tasks, 16};
    run.repeat = 2;
    run.picture = "runs/a.exr";
    run.seconds = 1.5, run.cpuSeconds = 2.5, run.peakMegabytes = 99;
    run.ssim = .9, run.flip = .1, run.error = 0.01, run.errorSe = .002, run.pngKb = 12.5, run.entropy = 6.5;
    run.oidnMode = "fast-raw", run.measuredAgainst = "state";
    run.meanRatio = {1, .99, 1.01};
    return run;
}

TEST(BenchJson, RunsComeBackAsTheyWere) {
    const BenchRun run = someRun();
    const auto back = runFromJson(toJson(run, "key"), "key");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->scene, run.scene);
    EXPECT_EQ(back->method, run.method);
    EXPECT_TRUE(back->budget == run.budget);
    EXPECT_EQ(back->repeat, 2);
    EXPECT_EQ(back->picture, run.picture);
    EXPECT_EQ(back->seconds, 1.5);
    EXPECT_TRUE(std::isnan(back->renderSeconds));
    EXPECT_EQ(back->entropy, 6.5);
    EXPECT_EQ(back->errorSe, .002);
    EXPECT_EQ(back->oidnMode, "fast-raw");
    EXPECT_EQ(back->measuredAgainst, "state");
    EXPECT_EQ(back->meanRatio, run.meanRatio);
}

TEST(BenchJson, FailuresComeBack) {
    BenchRun run = someRun();
    run.failure = "it \"fell\" over";
    EXPECT_EQ(runFromJson(toJson(run, "key"), "key")->failure, run.failure);
}

TEST(BenchJson, AnotherKeyAndDamageAreNoRun) {
    const std::string text = toJson(someRun(), "key");
    EXPECT_FALSE(runFromJson(text, "other"));
    EXPECT_FALSE(runFromJson("", "key"));
    for (size_t i = 1; i < text.size() - 1; i += 17) EXPECT_FALSE(runFromJson(text.substr(0, i), "key")) << i;
    EXPECT_FALSE(runFromJson("{\"key\": \"key\"}", "key"));
}

TEST(BenchJson, ReportsHaveMediansOfRepeats) {
    BenchReport report;
    report.methods = {"drc-maps:gaussian+oidn", "path"};
    report.budgets = {{BudgetUnit::Tasks, 16}};
    report.scenes.resize(1);
    report.scenes[0].name = "room";
    for (double ssim : {.7, .9, .8}) {
        report.runs.push_back(someRun());
        report.runs.back().ssim = ssim;
    }
    const auto json = nlohmann::json::parse(toJson(report));
    EXPECT_EQ(json["runs"].size(), 3u);
    ASSERT_EQ(json["summary"].size(), 1u);  // none of path, which has no runs
    EXPECT_EQ(json["summary"][0]["count"], 3);
    EXPECT_EQ(json["summary"][0]["ssim"]["median"], .8);
    EXPECT_EQ(json["summary"][0]["ssim"]["low"], .7);
    EXPECT_EQ(json["summary"][0]["ssim"]["high"], .9);
    EXPECT_TRUE(json["summary"][0]["render_seconds"]["median"].is_null());
    EXPECT_TRUE(json["summary"][0]["error_by_path_oidn"].is_null());
    report.methods.push_back("path+oidn:high");
    report.runs.push_back(someRun());
    report.runs.back().method = "path+oidn:high", report.runs.back().error = .02;
    EXPECT_EQ(nlohmann::json::parse(toJson(report))["summary"][0]["error_by_path_oidn"], .5);
}

}  // namespace
}  // namespace drc
