#include "bench/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Image flat(float value, int width = 16, int height = 12) {
    Image image(width, height);
    std::fill(image.data().begin(), image.data().end(), value);
    return image;
}

// Programs are shell scripts that copy a picture, and write a line to a file each time.
class BenchTest : public FolderTest {
  protected:
    BenchTest() {
        writeExr(path("half.exr"), flat(0.5f));
        writeExr(path("large.exr"), flat(0.5f, 32, 12));
        std::filesystem::create_directories(path("references"));
        writeExr(path("references/room.exr"), flat(0.4f));
        settings_.scenes = {folder_.write("room.pbrt", "WorldBegin\nWorldEnd\n")};
        settings_.references = path("references");
        settings_.output = path("out");
        settings_.threads = 2;
        settings_.budgets = {{BudgetUnit::Spp, 4}};
    }

    void addMethod(const std::string& name, const std::string& script) {
        Adapter adapter;
        adapter.name = name;
        adapter.install = "write it.";
        adapter.commands[BudgetUnit::Spp] = {"sh", "-c",
                                             "echo " + name + " {seed} {spp} >>" + path("log") + "; " + script};
        settings_.methods.emplace_back(name, [&](const std::string&) { return adapter; });
    }
    std::string copying(const std::string& picture) const { return "cp " + path(picture) + " {output}"; }
    // The lines of the log, and none of them any more.
    std::vector<std::string> calls() {
        std::vector<std::string> lines;
        std::ifstream in(path("log"));
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        std::filesystem::remove(path("log"));
        return lines;
    }
    BenchReport run(const CancelToken* cancel = nullptr) { return runBench(settings_, cancel); }

    BenchSettings settings_;
};

TEST_F(BenchTest, MeasuresWhatProgramsDo) {
    addMethod("copy", copying("half.exr") + "; echo '{{\"render_seconds\": 1.25, \"spp\": 7}}' >{timing}");
    const BenchReport report = run();
    ASSERT_EQ(report.runs.size(), 1u);
    const BenchRun& r = report.runs[0];
    EXPECT_EQ(r.failure, "");
    EXPECT_NEAR(r.meanRatio[0], 1.25, 1e-6);
    EXPECT_NEAR(r.error, 0.01 / 0.17, 1e-6);
    EXPECT_NEAR(r.blockError, 0.01 / 0.17, 1e-6);
    EXPECT_TRUE(std::isnan(r.errorSe) && std::isnan(r.trimmedError));
    EXPECT_EQ(r.entropy, 0);
    EXPECT_GT(r.pngKb, 0);
    EXPECT_GT(r.peakMegabytes, 0);
    EXPECT_EQ(r.renderSeconds, 1.25);
    EXPECT_EQ(r.spp, 7);
    EXPECT_TRUE(std::isnan(r.denoiseSeconds));  // nobody says that it took none
    EXPECT_GT(r.seconds, 0);
    EXPECT_TRUE(std::filesystem::exists(path("out/" + r.picture)));
    ASSERT_EQ(report.scenes.size(), 1u);
    EXPECT_EQ(report.scenes[0].width, 16);
    EXPECT_EQ(report.scenes[0].height, 12);
    EXPECT_EQ(report.scenes[0].referenceOrigin, "given");
    EXPECT_EQ(report.scenes[0].pair.size(), 0u);
}

// Against 0.4 +- 0.05 in a checkerboard: with the sign of their noise from one to the other.
TEST_F(BenchTest, OfAPairOfReferencesTheNoiseIsLeftOut) {
    for (const float sign : {1.f, -1.f}) {
        Image image = flat(0.4f);
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 16; ++x)
                image.setRgb(x, y, Rgb(0.4f + 0.05f * ((sign > 0 ? x + y : x) % 2 ? 1.f : -1.f)));
        writeExr(path(sign > 0 ? "references/room-1.exr" : "references/room-2.exr"), image);
    }
    addMethod("copy", copying("half.exr") + "; echo '{{\"load_seconds\": 1, \"denoise_seconds\": 2}}' >{timing}");
    const BenchReport report = run();
    ASSERT_EQ(report.runs.size(), 1u);
    EXPECT_EQ(report.runs[0].failure, "");
    EXPECT_NEAR(report.runs[0].error, 0.01 / 0.17, 1e-3);
    EXPECT_NEAR(report.runs[0].blockError, 0.01 / 0.17, 1e-3);
    EXPECT_NEAR(report.runs[0].meanRatio[0], 1.25, 1e-5);
    EXPECT_TRUE(std::isfinite(report.runs[0].errorSe) && std::isfinite(report.runs[0].trimmedErrorSe));
    EXPECT_EQ(report.runs[0].loadSeconds, 1);
    EXPECT_EQ(report.runs[0].denoiseSeconds, 2);
    const BenchScene& scene = report.scenes[0];
    ASSERT_EQ(scene.pair.size(), 2u);
    EXPECT_NEAR(scene.referenceNoise, 0.0025 / 0.17, 1e-3);
    EXPECT_GT(scene.flipNoise, 0);
    const Image mean = readLinearRgb(path("out/" + scene.reference));
    EXPECT_NEAR(mean.at(1, 1, 0), 0.4f, 1e-6f);
}

TEST_F(BenchTest, HalfAPairIsAnError) {
    addMethod("a", copying("half.exr"));
    std::filesystem::rename(path("references/room.exr"), path("references/room-1.exr"));
    EXPECT_THAT(errorOf([&] { run(); }), AllOf(HasSubstr("room-1.exr is there"), HasSubstr("room-2.exr")));
    std::filesystem::copy(path("references/room-1.exr"), path("references/room-2.exr"));
    EXPECT_THAT(errorOf([&] { run(); }), HasSubstr("are the same picture"));
}

// A better reference makes nobody render again.
TEST_F(BenchTest, PicturesAreMeasuredAnewWhenReferencesChange) {
    addMethod("a", copying("half.exr"));
    const double before = run().runs[0].error;
    calls();
    writeExr(path("references/room.exr"), flat(0.5f));
    EXPECT_GT(before, 0.01);
    EXPECT_NEAR(run().runs[0].error, 0, 1e-9);
    EXPECT_NEAR(run().runs[0].error, 0, 1e-9);
    EXPECT_TRUE(calls().empty());
}

TEST_F(BenchTest, MethodsAreInnermostAndRepeatsOutermost) {
    addMethod("a", copying("half.exr"));
    addMethod("b", copying("half.exr"));
    settings_.budgets = {{BudgetUnit::Spp, 4}, {BudgetUnit::Spp, 8}};
    settings_.repeats = 2;
    run();
    EXPECT_THAT(calls(), testing::ElementsAre("a 0 4", "b 0 4", "a 0 8", "b 0 8", "a 1 4", "b 1 4", "a 1 8", "b 1 8"));
}

TEST_F(BenchTest, WhatIsKnownIsNotRunAgain) {
    addMethod("a", copying("half.exr"));
    settings_.repeats = 2;
    const double seconds = run().runs[0].seconds;
    calls();
    EXPECT_EQ(run().runs[0].seconds, seconds);
    EXPECT_TRUE(calls().empty());
    addMethod("b", copying("half.exr"));
    EXPECT_EQ(run().runs.size(), 4u);
    EXPECT_EQ(calls().size(), 2u);  // of b
    folder_.write("room.pbrt", "# changed\nWorldBegin\nWorldEnd\n");
    run();
    EXPECT_EQ(calls().size(), 4u);
    settings_.threads = 1;  // {threads} is not among their arguments
    run();
    EXPECT_TRUE(calls().empty());
}

TEST_F(BenchTest, RemovedPicturesAndDamagedRecordsAreMadeAgain) {
    addMethod("a", copying("half.exr"));
    const std::string picture = path("out/" + run().runs[0].picture);
    calls();
    std::filesystem::remove(picture);
    run();
    EXPECT_EQ(calls().size(), 1u);
    std::filesystem::resize_file(picture.substr(0, picture.size() - 4) + ".json", 20);
    run();
    EXPECT_EQ(calls().size(), 1u);
}

TEST_F(BenchTest, FailuresSayWhatTheProgramSaid) {
    addMethod("refuses", "echo loading; echo 'line 3: no such shape' >&2; exit 1");
    addMethod("silent", "exit 3");
    addMethod("lazy", "true");
    addMethod("large", copying("large.exr"));
    addMethod("damaged", "echo >{output}");
    addMethod("slow", "sleep 60");
    settings_.limitSeconds = 1;
    const BenchReport report = run();
    ASSERT_EQ(report.runs.size(), 6u);
    EXPECT_EQ(report.runs[0].failure, "line 3: no such shape");
    EXPECT_EQ(report.runs[1].failure, "exit code 3");
    EXPECT_EQ(report.runs[2].failure, "ended without a picture");
    EXPECT_EQ(report.runs[3].failure, "wrote 32x12 pixels, not 16x12");
    EXPECT_THAT(report.runs[4].failure, HasSubstr(".exr"));
    EXPECT_THAT(report.runs[5].failure, HasSubstr("still running"));
    calls();
    settings_.methods.erase(settings_.methods.begin() + 1, settings_.methods.end());
    run();
    EXPECT_EQ(calls().size(), 1u);  // tried again
}

TEST_F(BenchTest, BudgetsThatAMethodDoesNotKeepAreLeftOut) {
    addMethod("a", copying("half.exr"));
    settings_.budgets = {{BudgetUnit::Seconds, 1}, {BudgetUnit::Spp, 4}, {BudgetUnit::Tasks, 2}};
    EXPECT_EQ(run().runs.size(), 1u);
}

TEST_F(BenchTest, CancellingKeepsWhatIsDone) {
    addMethod("a", copying("half.exr"));
    CancelToken cancel;
    cancel.cancel();
    EXPECT_TRUE(run(&cancel).runs.empty());
    EXPECT_TRUE(calls().empty());
}

TEST_F(BenchTest, WhatMakesItPointlessIsAnError) {
    addMethod("a", copying("half.exr"));
    const auto error = [&] { return errorOf([&] { run(); }); };
    settings_.scenes.push_back(folder_.write("other/room/scene.pbrt", ""));
    EXPECT_THAT(error(), HasSubstr("called room"));
    settings_.scenes = {folder_.write("hall.pbrt", "")};
    EXPECT_THAT(error(), HasSubstr("hall.exr"));
    settings_.scenes = {path("room.pbrt")};
    settings_.width = 32, settings_.height = 12;
    EXPECT_THAT(error(), AllOf(HasSubstr("16x12"), HasSubstr("32x12")));
    EXPECT_TRUE(calls().empty());
}

TEST_F(BenchTest, ProgramsThatAreNotInstalledAreAnErrorAtOnce) {
    Adapter adapter;
    adapter.name = "absent";
    adapter.install = "It is sold by the pound.";
    adapter.commands[BudgetUnit::Spp] = {"true"};
    adapter.check = {"sh", "-c", "echo no module of that name >&2; exit 1"};
    settings_.methods.emplace_back("absent", [&](const std::string&) { return adapter; });
    EXPECT_THAT(errorOf([&] { run(); }),
                AllOf(HasSubstr("absent"), HasSubstr("no module of that name"), HasSubstr("by the pound")));
    adapter.check = {"drc-no-such-program"};
    settings_.methods.clear();
    settings_.methods.emplace_back("absent", [&](const std::string&) { return adapter; });
    EXPECT_THAT(errorOf([&] { run(); }), AllOf(HasSubstr("drc-no-such-program"), HasSubstr("by the pound")));
}

TEST(SceneName, IsTheFilesOrTheFolders) {
    EXPECT_EQ(sceneName("/a/kitchen.pbrt"), "kitchen");
    EXPECT_EQ(sceneName("/a/kitchen/scene.pbrt"), "kitchen");
    EXPECT_EQ(sceneName("/a/kitchen/x/../scene.pbrt"), "kitchen");
}

}  // namespace
}  // namespace drc
