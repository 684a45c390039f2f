// Every sampler that a scene file may name must take the number of samples that the file says, all with equal weight.
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pbrt/scene_file.h"
#include "render/session.h"
#include "scene/shapes/shape_check.h"
#include "test_scenes.h"

namespace drc {
namespace {

struct SamplerCase {
    const char* name;  // as it is written in the test's scene; some exist in both dialects
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
// Radiance in a furnace whose walls reflect and emit 0.5, after kDepth bounces.
const double kRadiance = 1 - std::pow(0.5, kDepth + 1);

std::string furnaceWith(const SamplerCase& c) {
    const std::string text = std::string(c.directive) +
                             "\nPixelFilter \"box\"\nIntegrator \"path\" \"integer maxdepth\" " +
                             std::to_string(kDepth) + "\n" + test::furnace(0.5f, kWidth, kHeight);
    return c.v4 ? test::inWordsOfV4(text) : text;
}

std::vector<double> greenOf(const Image& image) {
    EXPECT_EQ(image.width(), kWidth);
    EXPECT_EQ(image.height(), kHeight);
    std::vector<double> values;
    for (int i = 0; i < kWidth * kHeight; ++i) values.push_back(double(image.rgb(i % kWidth, i / kWidth).y));
    return values;
}

// Pixels are independent of each other.
void expectUnbiased(const std::vector<double>& pixels) {
    RunningMean mean;
    for (const double v : pixels) mean.add(v);
    EXPECT_NEAR(mean.mean(), kRadiance, 4.5 * std::sqrt(mean.variance()));
    EXPECT_GT(mean.variance(), 1e-7) << "an estimate has some";
}

class Samplers : public testing::TestWithParam<SamplerCase> {};
INSTANTIATE_TEST_SUITE_P(Every, Samplers, testing::ValuesIn(kSamplers), [](const auto& i) { return i.param.name; });

TEST_P(Samplers, TakeTheirSamplesAndAreUnbiased) {
    const auto scene = pbrt::loadPbrtString(furnaceWith(GetParam()));
    EXPECT_EQ(scene->sensor.settings.samplesPerPixel, GetParam().spp);
    RenderParams params;
    params.integrator = "path";
    params.spp = scene->sensor.settings.samplesPerPixel;
    params.maxDepth = scene->sensor.settings.maxDepth;
    Session session(*scene, params);
    std::vector<double> sum(kWidth * kHeight);
    std::vector<std::vector<double>> samples;
    while (session.step()) {
        // The first sample of all pixels takes several passes.
        if (session.samplesDone() == int(samples.size())) continue;
        // The contribution of each sample to the picture.
        const std::vector<double> picture = greenOf(session.picture().beauty);
        samples.emplace_back();
        for (size_t i = 0; i < picture.size(); ++i) {
            samples.back().push_back(picture[i] * double(samples.size()) - sum[i]);
            sum[i] += samples.back()[i];
        }
        expectUnbiased(samples.back());
    }
    ASSERT_EQ(int(samples.size()), GetParam().spp);
    expectUnbiased(greenOf(session.picture().beauty));
    // No sample may be a repetition of another.
    for (size_t a = 0; a < samples.size(); ++a)
        for (size_t b = 0; b < a; ++b) {
            int same = 0;
            for (size_t i = 0; i < sum.size(); ++i) same += std::abs(samples[a][i] - samples[b][i]) < 1e-4;
            EXPECT_LT(same, kWidth * kHeight / 2) << a << " and " << b;
        }
}

// The command-line program must use the samples and depth of the file where it is told to.
TEST(SamplersOfTheProgram, AreTheFiles) {
    for (const SamplerCase* c : {&kSamplers[1], &kSamplers[13]}) {
        const TemporaryFolder folder;
        const std::string scene = folder.write("furnace.pbrt", furnaceWith(*c)), out = folder.path("out.exr");
        const std::string command = std::string("'") + DRC_PROGRAM + "' render '" + scene + "' -o '" + out +
                                    "' --integrator scene --nthreads 1 --quiet";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_EQ(readExrMetadata(out).at("drc:spp"), std::to_string(c->spp));
        EXPECT_EQ(readExrMetadata(out).at("drc:integrator"), "path");
        expectUnbiased(greenOf(readLinearRgb(out)));
    }
}

}  // namespace
}  // namespace drc
