#include "bench/bench_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <set>

#include "base/folder_testing.h"
#include "image/cross_error.h"
#include "image/image_io.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

using testing::HasSubstr;

// The renderer is a script: part N of a stream is its picture, the seed modulo four says of which.
class BenchReference : public FolderTest {
  protected:
    BenchReference() {
        settings_.program = folder_.write("drc",
                                          "#!/bin/sh\n"
                                          "here=$(dirname \"$0\")\n"
                                          "while [ $# -gt 0 ]; do case $1 in\n"
                                          "  --seed) seed=$2;; --spp) spp=$2;; -o) out=$2;; esac; shift; done\n"
                                          "echo $spp $seed >>$here/log\n"
                                          "cp $here/$((seed % 4)).exr $out\n");
        std::filesystem::permissions(settings_.program, std::filesystem::perms::owner_all);
        settings_.threads = 1;
        settings_.error = 1e-4;
        pictures(0);
    }
    // Streams that are 1 on average, with noise of that deviation.
    void pictures(float deviation) {
        std::mt19937 rng(1);
        std::normal_distribution<float> normal(1, deviation);
        for (int stream = 0; stream < 4; ++stream) {
            Image image(48, 48);
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x) image.setRgb(x, y, Rgb(deviation > 0 ? normal(rng) : 1));
            image.setRgb(0, 0, Rgb(1 + 0.01f * float(stream)));
            writeExr(path(std::to_string(stream) + ".exr"), image);
        }
    }
    RenderedReferences render(const std::string& key = "key", const CancelToken* cancel = nullptr) {
        return renderReferences("room.pbrt", "room", 48, 48, path("references"), key, settings_, cancel);
    }
    // Samples and seeds of the calls since the last time.
    std::vector<std::string> calls() {
        std::ifstream in(path("log"));
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        std::filesystem::remove(path("log"));
        return lines;
    }
    ReferenceSettings settings_;
};

TEST_F(BenchReference, AreTwoOfFourSeeds) {
    const RenderedReferences references = render();
    const auto lines = calls();
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), 4u);
    EXPECT_EQ(readLinearRgb(references.first).at(3, 3, 0), 1);
    EXPECT_NEAR(readLinearRgb(references.first).at(0, 0, 0), 1.005f, 1e-6f);   // of streams 0 and 1
    EXPECT_NEAR(readLinearRgb(references.second).at(0, 0, 0), 1.025f, 1e-6f);  // of streams 2 and 3
    EXPECT_THAT(references.origin, HasSubstr("path, 2 x 64 spp"));
}

// What is said of the error is what the noise of the pair puts into the cross error of the true picture.
TEST_F(BenchReference, SayTheErrorThatTheirNoiseLeaves) {
    pictures(0.2f);
    settings_.maxSpp = 64;
    const RenderedReferences references = render();
    // Of each reference the variance is 0.02; the mean of 48 x 48 products has the deviation 0.02 / 48 / 1.01.
    const double said = std::stod(references.origin.substr(references.origin.find("about ") + 6));
    EXPECT_NEAR(said, 0.02 / 48 / 1.01, 0.35 * 0.02 / 48);
    EXPECT_THAT(references.origin, HasSubstr("noise 2.0e-02"));
    Image truth(48, 48);
    std::fill(truth.data().begin(), truth.data().end(), 1);
    const Image first = readLinearRgb(references.first), second = readLinearRgb(references.second);
    const CrossErrors errors = crossErrors(first, second, relativeNorm(first, second), truth);
    EXPECT_LT(std::abs(errors.trimmed.mean), 4 * said);
}

TEST_F(BenchReference, GetMoreSamplesUntilTheyAreGoodEnough) {
    pictures(0.2f);  // the same in each part: never good enough
    settings_.maxSpp = 200;
    EXPECT_THAT(render().origin, HasSubstr("2 x 144 spp"));  // 64, 96, 144; then 216 would be
    EXPECT_EQ(calls().size(), 12u);
    // Good enough for a caller who wants less.
    settings_.error = 1e-2;
    render();
    EXPECT_TRUE(calls().empty());
    // One who wants more goes on.
    settings_.error = 1e-5;
    settings_.maxSpp = 220;
    EXPECT_THAT(render().origin, HasSubstr("2 x 216 spp"));
    const auto lines = calls();
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_THAT(lines[0], testing::StartsWith("36 "));
}

TEST_F(BenchReference, AreKeptForTheirKey) {
    render();
    calls();
    render();
    EXPECT_TRUE(calls().empty());
    render("another state of the scene");
    EXPECT_EQ(calls().size(), 4u);
    settings_.integrator = "bdpt";
    render("another state of the scene");
    EXPECT_EQ(calls().size(), 4u);
    std::filesystem::remove(path("references/room-48x48-2.exr"));
    render("another state of the scene");
    EXPECT_TRUE(calls().empty());  // the samples are there
    EXPECT_TRUE(std::filesystem::exists(path("references/room-48x48-2.exr")));
}

TEST_F(BenchReference, GoOnAfterAnInterruption) {
    std::filesystem::rename(path("2.exr"), path("hidden.exr"));
    EXPECT_THAT(errorOf([&] { render(); }), HasSubstr("references of room could not be rendered"));
    EXPECT_EQ(calls().size(), 3u);
    EXPECT_FALSE(std::filesystem::exists(path("references/room-48x48-1.exr")));
    std::filesystem::rename(path("hidden.exr"), path("2.exr"));
    render();
    EXPECT_EQ(calls().size(), 2u);  // the first two parts were there
}

TEST_F(BenchReference, CancelledThereAreNone) {
    CancelToken cancel;
    cancel.cancel();
    EXPECT_EQ(render("key", &cancel).first, "");
}

TEST_F(BenchReference, TooFewSamplesAreAnError) {
    settings_.maxSpp = 40;
    EXPECT_THAT(errorOf([&] { render(); }), HasSubstr("64 spp"));
}

}  // namespace
}  // namespace drc
