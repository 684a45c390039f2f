#include "bench/bench_table.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

class BenchTable : public testing::Test {
  protected:
    BenchTable() {
        report_.methods = {"drc", "path+oidn"};
        report_.budgets = {{BudgetUnit::Seconds, 10}, {BudgetUnit::Spp, 4}};
        report_.scenes.resize(1);
        report_.scenes[0].name = "room";
        report_.scenes[0].pair = {"room-1.exr", "room-2.exr"};
    }
    BenchRun& add(const std::string& method, double error) {
        BenchRun run;
        run.scene = "room", run.method = method, run.budget = report_.budgets[0];
        run.seconds = 9.96, run.ssim = .9, run.flip = .05, run.peakMegabytes = 210.4;
        run.error = error, run.errorSe = error / 100;
        run.trimmedError = error / 2, run.trimmedErrorSe = error / 200;
        run.blockError = error / 4, run.blockErrorSe = error / 400;
        run.loadSeconds = .5, run.renderSeconds = 9, run.denoiseSeconds = 0, run.writeSeconds = .25, run.spp = 33;
        run.meanRatio = {1, .999, 1.01};
        report_.runs.push_back(run);
        return report_.runs.back();
    }
    BenchReport report_;
};

TEST_F(BenchTable, HasErrorsTheirRatioAndWhatWasSpent) {
    for (const double error : {.01, .03, .02}) add("drc", error);
    add("path+oidn", .04).oidnMode = "balanced-raw";
    EXPECT_EQ(
        benchMarkdown(report_),
        "## 10 s\n\n"
        "| scene | method    | error             | trimmed           | 8x8 blocks        | / path+oidn | SSIM   | "
        "FLIP   | mean ratio RGB    | spp | load s | render s | denoise s | write s | whole s | MB  |\n"
        "|-------|-----------|-------------------|-------------------|-------------------|-------------|--------|-"
        "-------|-------------------|-----|--------|----------|-----------|---------|---------|-----|\n"
        "| room  | drc       | 0.02000 \u00b1 0.00020 | 0.01000 \u00b1 0.00010 | 0.00500 \u00b1 0.00005 | 0.50        "
        "| "
        "0.9000 | 0.0500 | 1.000 0.999 1.010 | 33  | 0.5    | 9.0      | 0.0       | 0.2     | 10.0    | 210 |\n"
        "| room  | path+oidn | 0.04000 \u00b1 0.00040 | 0.02000 \u00b1 0.00020 | 0.01000 \u00b1 0.00010 | 1.00        "
        "| "
        "0.9000 | 0.0500 | 1.000 0.999 1.010 | 33  | 0.5    | 9.0      | 0.0       | 0.2     | 10.0    | 210 |\n\n"
        "- room, path+oidn: Open Image Denoise in the mode balanced-raw\n\n");
}

TEST_F(BenchTable, SaysWhatFailedAndWhatIsNoise) {
    add("drc", .01);
    report_.runs.back().errorSe = report_.runs.back().trimmedError = kNotMeasured;
    add("path+oidn", .02).failure = "a|b";
    report_.scenes[0].pair.clear();
    const std::string text = benchMarkdown(report_);
    EXPECT_NE(text.find("| 0.01000 | -       | 0.00250"), std::string::npos) << text;
    EXPECT_NE(text.find("| room  | path+oidn | -"), std::string::npos) << text;
    EXPECT_NE(text.find("\n- room, path+oidn: a|b\n- room: one reference only; its noise is in the errors"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find('~'), std::string::npos) << text;
    report_.scenes[0].flipNoise = .02;
    const std::string noisy = benchMarkdown(report_);
    EXPECT_NE(noisy.find("| 0.9000 | ~0.0500 |"), std::string::npos) << noisy;
    EXPECT_NE(noisy.find("- ~: more than 25 %"), std::string::npos) << noisy;
}

}  // namespace
}  // namespace drc
