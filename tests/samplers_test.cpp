// Every sampler that a scene may name: as many samples as the file says, all of which count, and alike.
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pbrt/scene_file.h"
#include "render/renderer.h"
#include "test_scenes.h"

namespace drc {
namespace {

struct SamplerCase {
    const char* name;  // as the test has it: some are in both dialects
    bool v4;
    const char* directive;
    int spp;
};
void PrintTo(const SamplerCase& c, std::ostream* out) { *out << c.name; }
const SamplerCase kSamplers[] = {
    {"Random", false, R"(Sampler "random" "integer pixelsamples" 12)", 12},
    {"Stratified", false, R"(Sampler "stratified" "integer xsamples" 3 "integer ysamples" 5 "bool jitter" "true")", 15},
    {"Halton", false, R"(Sampler "halton" "integer pixelsamples" 20)", 20},
    {"ZeroTwoSequence", false, R"(Sampler "02sequence" "integer pixelsamples" 16)", 16},
    {"LowDiscrepancy", false, R"(Sampler "lowdiscrepancy" "integer pixelsamples" 8)", 8},
    {"MaxMinDist", false, R"(Sampler "maxmindist" "integer pixelsamples" 12)", 16},
    {"Sobol", false, R"(Sampler "sobol" "integer pixelsamples" 32)", 32},
    {"IndependentOfV4", true, R"(Sampler "independent" "integer pixelsamples" 12)", 12},
    {"StratifiedOfV4", true, R"(Sampler "stratified" "integer xsamples" 5 "integer ysamples" 2)", 10},
    {"HaltonOfV4", true, R"(Sampler "halton" "integer pixelsamples" 20)", 20},
    {"PaddedSobolOfV4", true, R"(Sampler "paddedsobol" "integer pixelsamples" 16)", 16},
    {"Pmj02bnOfV4", true, R"(Sampler "pmj02bn" "integer pixelsamples" 16)", 16},
    {"SobolOfV4", true, R"(Sampler "sobol" "integer pixelsamples" 32)", 32},
    {"ZSobolOfV4", true, R"(Sampler "zsobol" "integer pixelsamples" 8)", 8},
};

constexpr int kWidth = 24, kHeight = 16, kDepth = 4;
// Of a furnace whose walls reflect and emit a half each, after so many bounces.
const double kRadiance = 1 - std::pow(0.5, kDepth + 1);

std::string furnaceWith(const SamplerCase& c) {
    const std::string text = std::string(c.directive) +
                             "\nPixelFilter \"box\"\nIntegrator \"path\" \"integer maxdepth\" " +
                             std::to_string(kDepth) + "\n" + test::furnace(0.5f, kWidth, kHeight);
    return c.v4 ? test::inWordsOfV4(text) : text;
}

struct Pixels {
    explicit Pixels(const Image& image) {
        const double n = kWidth * kHeight;
        EXPECT_EQ(image.width(), kWidth);
        EXPECT_EQ(image.height(), kHeight);
        for (int i = 0; i < int(n); ++i) mean += double(image.rgb(i % kWidth, i / kWidth).y) / n;
        for (int i = 0; i < int(n); ++i)
            variance += std::pow(double(image.rgb(i % kWidth, i / kWidth).y) - mean, 2) / (n - 1);
    }
    // Pixels are independent of each other.
    void expectUnbiased() const {
        EXPECT_NEAR(mean, kRadiance, 4.5 * std::sqrt(variance / (kWidth * kHeight)));
        EXPECT_GT(variance, 1e-5) << "an estimate has some";
    }
    double mean = 0, variance = 0;  // of a pixel
};

class Samplers : public testing::TestWithParam<SamplerCase> {};
INSTANTIATE_TEST_SUITE_P(Every, Samplers, testing::ValuesIn(kSamplers), [](const auto& i) { return i.param.name; });

TEST_P(Samplers, TakeTheirSamplesAndAreUnbiased) {
    const auto scene = pbrt::loadPbrtString(furnaceWith(GetParam()));
    EXPECT_EQ(scene->settings.samplesPerPixel, GetParam().spp);
    const auto rendered = [&](int spp, uint64_t seed) {
        RenderParams params;
        params.integrator = Integrator::Path;
        params.spp = spp;
        params.seed = seed;
        params.path.maxDepth = scene->settings.maxDepth;
        Renderer renderer(*scene, params, nullptr, nullptr);
        while (renderer.step()) {
        }
        return Pixels(renderer.image().beauty);
    };
    const Pixels all = rendered(scene->settings.samplesPerPixel, 1), one = rendered(1, 2);
    all.expectUnbiased();
    one.expectUnbiased();
    // The noise is at most that of as many independent samples: none was left out or taken twice.
    EXPECT_LT(all.variance * GetParam().spp, 1.4 * one.variance);
}

// The program as a user runs it takes the file's samples and depth where it is told to.
TEST(SamplersOfTheProgram, AreTheFiles) {
    for (const SamplerCase* c : {&kSamplers[1], &kSamplers[13]}) {
        const TemporaryFolder folder;
        const std::string scene = folder.write("furnace.pbrt", furnaceWith(*c)), out = folder.path("out.exr");
        const std::string command = std::string("'") + DRC_PROGRAM + "' render '" + scene + "' -o '" + out +
                                    "' --integrator scene --nthreads 1 --quiet";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_EQ(readExrMetadata(out).at("drc:spp"), std::to_string(c->spp));
        EXPECT_EQ(readExrMetadata(out).at("drc:integrator"), "path");
        Pixels(readLinearRgb(out)).expectUnbiased();
    }
}

}  // namespace
}  // namespace drc
