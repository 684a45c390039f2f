#include "image/cross_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "image/noise_testing.h"
#include "image/relative_norm.h"
#include "image/relmse.h"

namespace drc {
namespace {

using namespace noise_testing;

constexpr int kWidth = 128, kHeight = 96;

CrossErrors errorsOf(const Image& first, const Image& second, const Image& test) {
    return crossErrors(first, second, relativeNorm(first, second), test);
}

// Means over many pairs of references, and how sure they are.
struct Simulation {
    Estimate error, trimmed, block;     // standard errors of these means
    double noise = 0, relmse = 0;       // relmse: against one of the references, as it is measured without a pair
    double spread = 0, saidSpread = 0;  // of `error`: deviation among the pairs, and what each says of itself
    double blockSpread = 0, saidBlockSpread = 0;
};

Estimate over(const std::vector<double>& values, double* deviation = nullptr) {
    double mean = 0, square = 0;
    for (const double v : values) mean += v / double(values.size());
    for (const double v : values) square += (v - mean) * (v - mean) / double(values.size() - 1);
    if (deviation) *deviation = std::sqrt(square);
    return {mean, std::sqrt(square / double(values.size()))};
}

// test: a new picture each time, or the same.
Simulation simulate(const Image& truth, const std::function<Image(Rng&)>& test, const Noise& noise, int blur = 0) {
    constexpr int kPairs = 60;
    Rng rng(11);
    std::vector<double> error, trimmed, block, noises, relmse, said, saidBlock;
    const auto reference = [&] {
        const Image image = noisy(truth, noise, rng);
        return blur == 0 ? image : blurred(image, blur);
    };
    for (int i = 0; i < kPairs; ++i) {
        const Image first = reference(), second = reference(), t = test(rng);
        const CrossErrors e = errorsOf(first, second, t);
        error.push_back(e.error.mean), trimmed.push_back(e.trimmed.mean), block.push_back(e.block.mean);
        said.push_back(e.error.standardError), saidBlock.push_back(e.block.standardError);
        noises.push_back(e.noise);
        relmse.push_back(radianceErrors(first, t).relmse);
    }
    Simulation s;
    s.error = over(error, &s.spread), s.trimmed = over(trimmed), s.block = over(block, &s.blockSpread);
    s.noise = over(noises).mean, s.relmse = over(relmse).mean;
    s.saidSpread = over(said).mean, s.saidBlockSpread = over(saidBlock).mean;
    return s;
}

// Too bright by so much everywhere, and wavy: errors of one sign are those that a norm with noise in it gets wrong.
Image wrong(const Image& truth, float brighter) {
    Image test = truth;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x)
            test.setRgb(x, y, truth.rgb(x, y) * (1 + brighter + brighter / 2 * std::sin(float(x + 2 * y) / 9)));
    return test;
}

void expectNear(const Estimate& measured, double truth, double share, const char* what) {
    EXPECT_NEAR(measured.mean, truth, 4 * measured.standardError + share * truth) << what;
    // Else the comparison would say nothing.
    EXPECT_LT(measured.standardError, 0.1 * truth) << what;
}

TEST(CrossError, ByHand) {
    Image first(32, 32), second(32, 32), test(32, 32);
    for (float& v : first.data()) v = 0.9f;
    for (float& v : second.data()) v = 1.1f;
    for (float& v : test.data()) v = 1.5f;
    const CrossErrors e = errorsOf(first, second, test);
    EXPECT_NEAR(e.error.mean, 0.6 * 0.4 / 1.01, 1e-6);
    EXPECT_NEAR(e.block.mean, 0.6 * 0.4 / 1.01, 1e-6);
    EXPECT_NEAR(e.error.standardError, 0, 1e-9);
    EXPECT_NEAR(e.noise, 0.04 / 2 / 1.01, 1e-6);
    EXPECT_NEAR(e.blockNoise, 0.04 / 2 / 1.01, 1e-6);
    for (const double ratio : e.meanRatio) EXPECT_NEAR(ratio, 1.5, 1e-6);
}

// The references' noise has up to thirty times the error that is measured.
TEST(CrossError, HasNoReferenceNoise) {
    const Image truth = scene(kWidth, kHeight);
    const Image test = wrong(truth, 0.05f);
    const CrossErrors exact = errorsOf(truth, truth, test);
    for (const float deviation : {0.05f, 0.15f, 0.3f}) {
        const Simulation s = simulate(
            truth, [&](Rng&) { return test; }, gaussian(deviation));
        expectNear(s.error, exact.error.mean, 0.02, "error");
        expectNear(s.trimmed, exact.trimmed.mean, 0.02, "trimmed");
        expectNear(s.block, exact.block.mean, 0.02, "block");
        EXPECT_GT(s.relmse, exact.error.mean + 0.5 * deviation * deviation);
        EXPECT_NEAR(s.noise, deviation * deviation, 0.2 * deviation * deviation);
    }
}

TEST(CrossError, HasNoFirefliesOfTheReferences) {
    const Image truth = scene(kWidth, kHeight);
    const Image test = wrong(truth, 0.05f);
    const CrossErrors exact = errorsOf(truth, truth, test);
    const Simulation few = simulate(
        truth, [&](Rng&) { return test; }, fireflies(2000, 10, 0.05f));
    EXPECT_GT(few.noise, 10 * exact.error.mean);
    expectNear(few.error, exact.error.mean, 0.03, "error");
    expectNear(few.trimmed, exact.trimmed.mean, 0.03, "trimmed");
    expectNear(few.block, exact.block.mean, 0.03, "block");
    // They have 3 % of the radiance: pixels where both have one count less than they should, by (3 %)^2 in all.
    const Simulation many = simulate(
        truth, [&](Rng&) { return test; }, fireflies(1000, 30, 0.05f));
    EXPECT_LT(many.error.mean, exact.error.mean + 4 * many.error.standardError);
    EXPECT_GT(many.error.mean, exact.error.mean - 0.03 * 0.03 - 4 * many.error.standardError);
    EXPECT_NEAR(many.block.mean, exact.block.mean, 4 * many.block.standardError);
}

// As with a pixel filter of three pixels by splatting.
TEST(CrossError, HasNoNoiseThatNeighboursShare) {
    const Image truth = blurred(scene(kWidth, kHeight), 1);
    const Image test = wrong(truth, 0.05f);
    const CrossErrors exact = errorsOf(truth, truth, test);
    const Simulation s = simulate(
        scene(kWidth, kHeight), [&](Rng&) { return test; }, gaussian(0.3f), 1);
    expectNear(s.error, exact.error.mean, 0.03, "error");
    expectNear(s.block, exact.block.mean, 0.03, "block");
}

TEST(CrossError, OfThePerfectPictureIsZero) {
    const Image truth = scene(kWidth, kHeight);
    for (const Noise& noise : {gaussian(0.2f), fireflies(2000, 10, 0.1f)}) {
        const Simulation s = simulate(
            truth, [&](Rng&) { return truth; }, noise);
        EXPECT_LT(std::abs(s.error.mean), 4 * s.error.standardError);
        EXPECT_LT(std::abs(s.trimmed.mean), 4 * s.trimmed.standardError);
        EXPECT_LT(std::abs(s.block.mean), 4 * s.block.standardError);
        EXPECT_LT(s.error.standardError, 0.02 * s.noise);
    }
}

// Errors that neighbours share, new each time, and noisy references: what each says of itself is how far all lie apart.
TEST(CrossError, StandardErrorIsTheSpread) {
    const Image truth = scene(kWidth, kHeight);
    const auto test = [&](Rng& rng) {
        Image white(kWidth, kHeight);
        for (float& v : white.data()) v = 1;
        const Image blotches = blurred(noisy(white, gaussian(0.3f), rng), 2);
        Image image = truth;
        for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] *= blotches.data()[i];
        return image;
    };
    for (const Noise& noise : {gaussian(0.02f), gaussian(0.3f)}) {
        const Simulation s = simulate(truth, test, noise);
        EXPECT_GT(s.saidSpread, 0.75 * s.spread);
        EXPECT_LT(s.saidSpread, 1.6 * s.spread);
        EXPECT_GT(s.saidBlockSpread, 0.75 * s.blockSpread);
        EXPECT_LT(s.saidBlockSpread, 1.6 * s.blockSpread);
    }
}

// Noise goes, a patch that is too bright stays.
TEST(CrossError, BlocksKeepWhatNeighboursShare) {
    const Image truth = scene(kWidth, kHeight);
    const Simulation noise = simulate(
        truth, [&](Rng& rng) { return noisy(truth, gaussian(0.2f), rng); }, gaussian(0.1f));
    EXPECT_LT(noise.block.mean, 0.05 * noise.error.mean);
    const CrossErrors bright = errorsOf(truth, truth, wrong(truth, 0.1f));
    EXPECT_GT(bright.block.mean, 0.7 * bright.error.mean);
}

TEST(CrossError, TrimmedLeavesOutFirefliesOfThePictureAndStaysUnbiased) {
    const Image truth = scene(kWidth, kHeight);
    Image test = wrong(truth, 0.05f);
    const double before = errorsOf(truth, truth, test).trimmed.mean;
    for (int i = 0; i < 8; ++i) test.setRgb(10 + 14 * i, 40 + 3 * i, Rgb(200));  // of 12 that are left out
    const CrossErrors exact = errorsOf(truth, truth, test);
    EXPECT_GT(exact.error.mean, 10);
    EXPECT_NEAR(exact.trimmed.mean, before, 0.02 * before);
    const Simulation s = simulate(
        truth, [&](Rng&) { return test; }, gaussian(0.2f));
    EXPECT_NEAR(s.trimmed.mean, exact.trimmed.mean, 4 * s.trimmed.standardError + 0.02 * before);
    EXPECT_LT(s.trimmed.standardError, 0.1 * before);
}

TEST(CrossError, LeavesOutWhatIsNotFinite) {
    Rng rng(1);
    const Image truth = scene(32, 32);
    Image first = noisy(truth, gaussian(0.1f), rng), second = noisy(truth, gaussian(0.1f), rng), test = truth;
    first.at(1, 1, 0) = std::numeric_limits<float>::quiet_NaN();
    second.at(2, 2, 2) = second.at(3, 3, 0) = std::numeric_limits<float>::infinity();
    test.at(4, 4, 1) = test.at(4, 4, 2) = -std::numeric_limits<float>::infinity();
    const CrossErrors e = errorsOf(first, second, test);
    EXPECT_EQ(e.nonFinite, (std::array<int64_t, 3>{1, 2, 1}));
    EXPECT_TRUE(std::isfinite(e.error.mean) && std::isfinite(e.trimmed.mean) && std::isfinite(e.block.mean));
    EXPECT_TRUE(std::isfinite(e.noise) && std::isfinite(e.meanRatio[1]));
    for (float& v : test.data()) v = NAN;
    EXPECT_TRUE(std::isnan(errorsOf(first, second, test).error.mean));
    EXPECT_TRUE(std::isnan(errorsOf(first, second, test).meanRatio[0]));
    EXPECT_THROW(errorsOf(first, second, Image(8, 8)), Error);
}

}  // namespace
}  // namespace drc
