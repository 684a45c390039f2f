#include "maps/map_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/folder_testing.h"
#include "maps/example_shard.h"
#include "maps/example_testing.h"

namespace drc {
namespace {

using Radiance = std::vector<float>;

Radiance noise(const MapLayout& layout, unsigned seed) {
    std::mt19937 rng{seed};
    std::exponential_distribution<float> e(1);
    Radiance radiance(size_t(3 * layout.texels()));
    for (float& r : radiance) r = e(rng);
    return radiance;
}

Radiance scaled(Radiance radiance, float factor) {
    for (float& r : radiance) r *= factor;
    return radiance;
}

const MapLayout kSmall(Projection::EqualArea, 2);
const MapLayout kFull(Projection::EqualArea, 32);
const MapLayout kLatLong(Projection::LatLong, 32);

TEST(MapEvaluation, L1IsInUnitsOfTheTargetsMean) {
    // The target is 2 everywhere. In the map one of four texels is off by 4 in one of three channels: (4 / 2) / 12.
    Radiance target(12, 2.f), map(12, 2.f);
    map[5] = 6;
    EXPECT_NEAR(scoreMap(map, target, kSmall).l1, 2.0 / 12, 1e-7);
}

TEST(MapEvaluation, L1WeighsTexelsBySolidAngle) {
    // A row of a latlong map covers the share (cos top - cos bottom) / 2 of the hemisphere.
    const MapLayout layout(Projection::LatLong, 4);
    Radiance target(48, 1.f), map(48, 1.f);
    for (size_t c = 0; c < 3; ++c)
        for (size_t column = 0; column < 4; ++column) map[c * 16 + column] = 3;
    EXPECT_NEAR(scoreMap(map, target, layout).l1, 2 * (1 - std::cos(kPi / 4)) / 2, 1e-6);
}

TEST(MapEvaluation, APerfectMapHasNoError) {
    for (const MapLayout& layout : {kFull, kLatLong}) {
        const Radiance target = noise(layout, 1);
        const MapScores scores = scoreMap(target, target, layout);
        EXPECT_EQ(scores.l1, 0);
        EXPECT_NEAR(scores.ssim, 1, 1e-9);
        EXPECT_EQ(scores.irradiance, 0);
    }
}

TEST(MapEvaluation, ScoresDoNotDependOnTheScenesUnits) {
    const Radiance target = noise(kFull, 1), map = noise(kFull, 2);
    const MapScores a = scoreMap(map, target, kFull), b = scoreMap(scaled(map, 1024), scaled(target, 1024), kFull);
    EXPECT_NEAR(a.l1, b.l1, 1e-6);
    EXPECT_NEAR(a.ssim, b.ssim, 1e-5);
    EXPECT_NEAR(a.irradiance, b.irradiance, 1e-6);
}

TEST(MapEvaluation, EqualEnergyForgivesAFactorAndNothingElse) {
    const Radiance target = noise(kFull, 1);
    EXPECT_GT(scoreMap(scaled(target, 3), target, kFull).l1, 1.9);
    EXPECT_NEAR(scoreMap(withMeanOf(scaled(target, 3), target, kFull), target, kFull).l1, 0, 1e-6);
    EXPECT_NEAR(scoreMap(withMeanOf(scaled(target, 3), target, kFull), target, kFull).ssim, 1, 1e-6);
    const Radiance other = noise(kFull, 2);
    EXPECT_NEAR(hemisphereMean(withMeanOf(other, target, kFull), kFull), hemisphereMean(target, kFull), 1e-6);
    EXPECT_GT(scoreMap(withMeanOf(other, target, kFull), target, kFull).l1, 0.5);
}

TEST(MapEvaluation, ABlackMapStaysBlackAndIsWrongByTheTarget) {
    const Radiance target = noise(kFull, 1), black(target.size(), 0.f);
    const Radiance same = withMeanOf(black, target, kFull);
    EXPECT_EQ(same, black);
    EXPECT_NEAR(scoreMap(same, target, kFull).l1, 1, 1e-6);
}

TEST(MapEvaluation, UniformErrorOfTheIrradianceFollowsFromItsFormula) {
    // Under uniform light of radiance 1, a normal tilted by theta receives the irradiance pi (1 + cos theta) / 2. The
    // map has twice the light.
    const Radiance target(size_t(3 * kFull.texels()), 1.f);
    double expected = 0;
    const MapLayout normals(Projection::EqualArea, 8);
    for (int i = 0; i < 64; ++i) {
        const double t = 0.5 * (1 + double(normals.direction(i % 8, i / 8, Vec2(0.5f, 0.5f)).z));
        expected += t * t / (t * t + 0.01) / 64;
    }
    EXPECT_NEAR(scoreMap(scaled(target, 2), target, kFull).irradiance, expected, 1e-3);
}

TEST(MapEvaluation, BlurredNoiseIsMoreSimilarThanNoise) {
    const Radiance target(size_t(3 * kFull.texels()), 1.f);
    std::vector<CapturedMap> maps(1);
    maps[0].radiance = noise(kFull, 1);
    const double noisy = scoreMap(maps[0].radiance, target, kFull).ssim;
    makeGaussianMapDenoiser(1)->denoise(maps, kFull);
    EXPECT_GT(scoreMap(maps[0].radiance, target, kFull).ssim, noisy + 0.01);
    EXPECT_LT(noisy, 0.5);
}

TEST(MapEvaluation, MapsBelowTheWindowHaveNoSsim) {
    EXPECT_TRUE(std::isnan(scoreMap(Radiance(12, 1.f), Radiance(12, 1.f), kSmall).ssim));
}

TEST(MapEvaluation, ADarkMapWithOneLitTexelHasAnExposure) {
    Radiance target(size_t(3 * kFull.texels()), 0.f);
    target[500] = 1e-3f;
    EXPECT_NEAR(scoreMap(target, target, kFull).ssim, 1, 1e-9);
}

// Two examples with three realisations each.
TEST(MapEvaluation, EachInputMeetsItsOwnTarget) {
    const TemporaryFolder folder;
    const std::string path = folder.path("test.examples");
    std::vector<TrainingExample> examples{randomExample(kFull, 3, 1), randomExample(kFull, 3, 2)};
    for (unsigned i = 0; i < 6; ++i) examples[i / 3].inputs[i % 3].radiance = noise(kFull, i);
    // The target of the first example is its second realisation, that of the second example its first.
    examples[0].target = noise(kFull, 1);
    examples[1].target = noise(kFull, 3);
    writeShard(path, "test", kFull, examples);

    const ExampleShard file(path);
    const auto none = makeIdentityMapDenoiser();
    const MapDenoiser* const mapDenoisers[] = {none.get()};
    const auto first = evaluateMapDenoisers(file, mapDenoisers, 1), all = evaluateMapDenoisers(file, mapDenoisers, 100);
    ASSERT_EQ(first.size(), 2u);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_GT(first[0].scores[0].asRendered.l1, 0.5);
    EXPECT_EQ(first[1].scores[0].asRendered.l1, 0);
    EXPECT_EQ(first[1].viewpoint, 1);
    EXPECT_EQ(first[1].film, examples[1].film);
    const double a = scoreMap(noise(kFull, 0), noise(kFull, 1), kFull).l1;
    const double b = scoreMap(noise(kFull, 2), noise(kFull, 1), kFull).l1;
    constexpr double kHalf = 1.0 / 2048;  // relative rounding error of the halves in which examples are stored
    EXPECT_NEAR(first[0].scores[0].asRendered.l1, a, a * kHalf);
    EXPECT_NEAR(all[0].scores[0].asRendered.l1, (a + b) / 3, a * kHalf);
}

// Each map denoiser must get the captured map, not the output of the one before it.
TEST(MapEvaluation, MapDenoisersDoNotSeeEachOther) {
    const TemporaryFolder folder;
    const std::string path = folder.path("test.examples");
    std::vector<TrainingExample> examples;
    for (unsigned i = 0; i < 11; ++i) examples.push_back(randomExample(kFull, 2, i));
    writeShard(path, "test", kFull, examples);
    const ExampleShard file(path);
    const auto none = makeIdentityMapDenoiser(), gaussian = makeGaussianMapDenoiser(1);
    const MapDenoiser* const together[] = {none.get(), gaussian.get(), none.get(), gaussian.get()};
    const auto scores = evaluateMapDenoisers(file, together, 2);
    ASSERT_EQ(scores.size(), examples.size());
    for (size_t i = 0; i < scores.size(); ++i) {
        ASSERT_EQ(scores[i].scores.size(), 4u);
        EXPECT_EQ(scores[i].viewpoint, int(i));
        EXPECT_EQ(scores[i].scores[0].asRendered.l1, scores[i].scores[2].asRendered.l1);
        EXPECT_EQ(scores[i].scores[1].asRendered.ssim, scores[i].scores[3].asRendered.ssim);
        EXPECT_GT(scores[i].scores[0].asRendered.l1, scores[i].scores[1].asRendered.l1);
    }
}

}  // namespace
}  // namespace drc
