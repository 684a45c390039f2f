#include "film/film_layer.h"

#include <gtest/gtest.h>

#include <random>

#include "base/parallel.h"

namespace drc {
namespace {

constexpr PixelRegion kRegion{3, 4, 5, 6};
using Storage = FilmLayerSpec::Storage;

class EveryStorage : public testing::TestWithParam<Storage> {
  protected:
    FilmLayer layer(int groups) const { return {kRegion, {.name = "l", .groups = groups, .storage = GetParam()}}; }
};
INSTANTIATE_TEST_SUITE_P(FilmLayer, EveryStorage, testing::Values(Storage::Exact, Storage::Single));

TEST_P(EveryStorage, MeansGoByFilterWeight) {
    FilmLayer l = layer(4);
    l.add(4, 5, 0, Rgb(1, 2, 3), 1);
    l.add(4, 5, 0, Rgb(5, 2, 3), 3);
    l.add(4, 5, 2, Rgb(8, 0, 0), 4);
    EXPECT_EQ(l.group(4, 5, 0), Rgb(4, 2, 3));
    EXPECT_EQ(l.group(4, 5, 2), Rgb(8, 0, 0));
    EXPECT_EQ(l.group(4, 5, 1), Rgb(0.f));
    EXPECT_EQ(l.mean(4, 5), Rgb(6, 1, 1.5f));
    EXPECT_EQ(l.mean(3, 4), Rgb(0.f));
    EXPECT_EQ(l.image(2).rgb(1, 1), Rgb(12, 2, 3));
    EXPECT_EQ(l.expected(4, 5), 3);
    EXPECT_EQ(l.groupsWithSamples(4, 5), 2);
}

TEST_P(EveryStorage, VarianceOfTheMeanIsByHowGroupsDiffer) {
    FilmLayer l = layer(4);
    EXPECT_EQ(l.varianceOfMean(3, 4), Rgb(0.f));
    l.add(3, 4, 0, Rgb(1, 5, 0), 1);
    EXPECT_EQ(l.varianceOfMean(3, 4), Rgb(0.f));
    l.add(3, 4, 1, Rgb(2, 5, 0), 1);
    l.add(3, 4, 2, Rgb(3, 5, 0), 1);
    EXPECT_FALSE(l.complete(3, 4));
    l.add(3, 4, 3, Rgb(6, 5, 0), 1);
    EXPECT_TRUE(l.complete(3, 4));
    // The squared differences from 3 sum to 14; 14 / 3 is the variance of a group, and a quarter of it that of the
    // mean.
    EXPECT_FLOAT_EQ(l.varianceOfMean(3, 4).x, 14.f / 12);
    EXPECT_EQ(l.varianceOfMean(3, 4).y, 0);
}

TEST(FilmLayer, ImportanceWeighsPasses) {
    FilmLayer l(kRegion, {.name = "l", .groups = 4, .storage = Storage::Single});
    // Of two groups, one with three times the weight: weights 1/4 and 3/4 about the mean 3.
    l.add(4, 5, 0, Rgb(0.f), 1, 2);
    l.add(4, 5, 1, Rgb(4.f), 1, 6);
    EXPECT_EQ(l.mean(4, 5), Rgb(3.f));
    EXPECT_FLOAT_EQ(l.varianceOfMean(4, 5).x, 2 * (9.f / 16 + 9.f / 16));
}

// Weights of a filter with negative lobes may cancel, while the weighted values do not.
TEST_P(EveryStorage, WeightsThatCancelDivideByWhatTheyShouldBe) {
    FilmLayer l = layer(1);
    l.add(3, 4, 0, Rgb(1, 1, 1), 1);
    l.add(3, 4, 0, Rgb(2, 2, 2), -0.9f);
    EXPECT_NEAR(l.group(3, 4, 0).x, (1 - 0.9f * 2) / 2, 1e-6f);
}

// Samples between 1e-6 and 1e6, in every order and any division into layers.
TEST(FilmLayer, ExactSumsDoNotDependOnTheOrder) {
    const FilmLayerSpec spec{.name = "l", .groups = 2};
    std::mt19937 rng(1);
    std::uniform_real_distribution<float> exponent(-6, 6), weight(-0.2f, 1.2f);
    struct Sample {
        Rgb value;
        float weight;
    };
    std::vector<Sample> samples(1000);
    for (Sample& s : samples) s = {Rgb(std::pow(10.f, exponent(rng))), weight(rng)};
    FilmLayer all(kRegion, spec);
    for (const Sample& s : samples) all.add(3, 4, 1, s.value, s.weight);
    std::shuffle(samples.begin(), samples.end(), rng);
    FilmLayer a(kRegion, spec), b(kRegion, spec);
    for (size_t i = 0; i < samples.size(); ++i) (i % 3 ? a : b).add(3, 4, 1, samples[i].value, samples[i].weight);
    b.add(a);
    EXPECT_EQ(all.mean(3, 4), b.mean(3, 4));
    EXPECT_TRUE(std::ranges::equal(all.row(4), b.row(4)));
    double sum = 0;
    for (const Sample& s : samples) sum += double(s.value.x) * double(s.weight);
    EXPECT_NEAR(all.sum(3, 4, 0), sum, 1e-4 + 1e-9 * std::abs(sum));
}

TEST(FilmLayer, ExactSumsSaturate) {
    FilmLayer l(kRegion, {.name = "l"});
    for (int i = 0; i < 5; ++i) l.add(3, 4, 0, Rgb(1e30f, -1e30f, 1), 1);
    EXPECT_GT(l.mean(3, 4).x, 5e10f);
    EXPECT_LT(l.mean(3, 4).y, -5e10f);
    EXPECT_EQ(l.mean(3, 4).z, 1);
}

// The quantum follows the film's scale: a dim scene that is brightened for display keeps its precision.
TEST(FilmLayer, TheQuantumFollowsTheScale) {
    EXPECT_EQ(radianceQuantum(1), 0x1p-24);
    for (const float scale : {1e-5f, 1.f, 1e6f}) {
        FilmLayer l(kRegion, {.name = "l", .quantum = radianceQuantum(scale)});
        l.add(3, 4, 0, Rgb(0.01f / scale), 1);
        EXPECT_NEAR(l.mean(3, 4).x * scale, 0.01, 1e-7) << scale;
    }
    EXPECT_GT(radianceQuantum(0), 0);
}

TEST(FilmLayer, SplatsSaturate) {
    FilmLayer l({0, 0, 8, 8}, {.name = "splats", .weighted = false});
    for (int i = 0; i < 5; ++i) l.splat(4, 4, Rgb(1e30f, -1e30f, 1));
    EXPECT_NEAR(l.sum(4, 4, 0), 0x1p39, 1);  // 2^63 quanta of 2^-24
    EXPECT_NEAR(l.sum(4, 4, 1), -0x1p39, 1);
    EXPECT_EQ(l.sum(4, 4, 2), 5);
}

TEST(FilmLayer, SplatsMayComeFromAnyThread) {
    FilmLayer l(kRegion, {.name = "l", .weighted = false});
    parallelFor(0, 10000, 10, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) l.splat(4, 4, Rgb(0.5f, 1, 0));
    });
    EXPECT_EQ(l.sum(4, 4, 0), 5000);
    EXPECT_EQ(l.sum(4, 4, 1), 10000);
    EXPECT_EQ(l.sum(3, 4, 1), 0);
}

TEST(FilmLayer, MemoryIsByItsSpec) {
    EXPECT_EQ((FilmLayerSpec{.name = "l"}.bytesPerPixel()), 5 * 8);
    EXPECT_EQ((FilmLayerSpec{.name = "l", .groups = 4, .storage = Storage::Single}.bytesPerPixel()), 4 * 5 * 4);
    EXPECT_EQ((FilmLayerSpec{.name = "l", .channels = 8, .weighted = false}.bytesPerPixel()), 8 * 8);
}

}  // namespace
}  // namespace drc
