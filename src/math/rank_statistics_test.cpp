#include "math/rank_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drc {
namespace {

// The expected values are those of SciPy 1.x unless another source is named.

TEST(RankStatistics, QuartilesAreLinearBetweenSortedValues) {
    const Summary s = summarise(std::vector<double>{7, 1, 3, 12, 5, 9});
    EXPECT_NEAR(s.mean, 37.0 / 6, 1e-14);
    EXPECT_NEAR(s.p5, 1.5, 1e-14);
    EXPECT_NEAR(s.q1, 3.5, 1e-14);
    EXPECT_NEAR(s.median, 6, 1e-14);
    EXPECT_NEAR(s.q3, 8.5, 1e-14);
    EXPECT_NEAR(s.p95, 11.25, 1e-14);
    const Summary one = summarise(std::vector<double>{2});
    EXPECT_EQ(one.p5, 2);
    EXPECT_EQ(one.p95, 2);
    EXPECT_TRUE(std::isnan(summarise({}).median));
    EXPECT_TRUE(std::isnan(summarise(std::vector<double>{1, NAN, 2}).mean));
}

TEST(RankStatistics, WilcoxonAgreesWithAKnownExample) {
    // Darwin's maize: differences in height of 15 pairs. The smaller rank sum is 24; its expectation is 60 and its
    // variance 310, so z = -2.0447.
    const std::vector<double> difference{6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75}, zero(15, 0.0);
    const PairedComparison result = compareSmaller(zero, difference);
    EXPECT_NEAR(result.p, 0.0409, 1e-4);
    EXPECT_NEAR(result.better, 13.0 / 15, 1e-12);
    EXPECT_NEAR(compareSmaller(difference, zero).p, result.p, 1e-12);
}

TEST(RankStatistics, WilcoxonSharesRanksOfTiesAndLeavesOutEqualPairs) {
    // If all differences have one size, the test becomes the sign test: z = (4 - 1) / sqrt(5).
    const std::vector<double> a(7, 0.0), b{1, 1, -1, 0, 1, 1, 0};
    EXPECT_NEAR(compareSmaller(a, b).p, std::erfc(3 / std::sqrt(5.0) / std::sqrt(2.0)), 1e-12);
    EXPECT_NEAR(compareSmaller(a, b).better, 4.0 / 7, 1e-12);
    EXPECT_EQ(compareSmaller(a, a).p, 1);
    const std::vector<double> broken{1, NAN}, fine{2, 3};
    EXPECT_TRUE(std::isnan(compareSmaller(broken, fine).p));
}

TEST(RankStatistics, WilcoxonOfSixtyPairs) {
    std::vector<double> difference, zero(60, 0.0);
    for (int i = 0; i < 60; ++i) difference.push_back((i * 37 % 101 - 45) / 4.0);
    EXPECT_NEAR(compareSmaller(zero, difference).p, 0.2647081919479235, 1e-12);
}

// Compares with published tables of the chi-square distribution, and with values far beyond them.
TEST(RankStatistics, ChiSquareTail) {
    EXPECT_NEAR(chiSquareUpperTail(3.841458820694124, 1), 0.05, 1e-14);
    EXPECT_NEAR(chiSquareUpperTail(5.991464547107979, 2), 0.05, 1e-14);
    EXPECT_NEAR(chiSquareUpperTail(7.814727903251179, 3), 0.05, 1e-14);
    EXPECT_NEAR(chiSquareUpperTail(11.070497693516351, 5), 0.05, 1e-14);
    EXPECT_NEAR(chiSquareUpperTail(0.5, 4), 0.9735009788392561, 1e-14);
    EXPECT_NEAR(chiSquareUpperTail(100, 7) / 1.0787979671702833e-18, 1, 1e-11);
    EXPECT_NEAR(chiSquareUpperTail(1000, 2) / 7.124576406741474e-218, 1, 1e-11);
    EXPECT_NEAR(chiSquareUpperTail(1200, 3) / 7.331671591550422e-260, 1, 1e-11);
    EXPECT_NEAR(chiSquareUpperTail(1300, 1) / 1.1303728441493301e-284, 1, 1e-11);
    EXPECT_EQ(chiSquareUpperTail(0, 3), 1);
    EXPECT_TRUE(std::isnan(chiSquareUpperTail(NAN, 3)));
}

using Samples = std::vector<std::vector<double>>;

TEST(RankStatistics, KruskalWallisAgreesWithAKnownExample) {
    // Hollander and Wolfe, "Nonparametric Statistical Methods", 1973, page 116: mucociliary efficiency of three groups.
    const Samples samples{{2.9, 3.0, 2.5, 2.6, 3.2}, {3.8, 2.7, 4.0, 2.4}, {2.8, 3.4, 3.7, 2.2, 2.0}};
    const KruskalWallis result = kruskalWallis(samples);
    EXPECT_NEAR(result.h, 0.7714285714285722, 1e-12);
    EXPECT_EQ(result.degreesOfFreedom, 2);
    EXPECT_NEAR(result.p, 0.6799647735788936, 1e-12);
}

TEST(RankStatistics, KruskalWallisCorrectsForTies) {
    const Samples samples{{1, 1, 1, 2, 2}, {2, 2, 3, 3, 3}, {1, 3, 3, 4, 4, 4}};
    EXPECT_NEAR(kruskalWallis(samples).h, 7.372248427672951, 1e-12);
    EXPECT_NEAR(kruskalWallis(samples).p, 0.025068975986008872, 1e-12);
    const Samples two{samples[0], samples[2]};
    EXPECT_NEAR(kruskalWallis(two).p, 0.029228829459242267, 1e-12);
    EXPECT_EQ(kruskalWallis(two).degreesOfFreedom, 1);
    // Neither the order of the samples nor a monotonically increasing function of the values matters.
    Samples turned{samples[2], samples[0], samples[1]};
    for (auto& sample : turned)
        for (double& v : sample) v = std::exp(3 * v);
    EXPECT_NEAR(kruskalWallis(turned).p, kruskalWallis(samples).p, 1e-12);
}

TEST(RankStatistics, KruskalWallisOfLargeSamples) {
    Samples samples(3);
    for (int i = 0; i < 200; ++i) {
        samples[0].push_back(i * 7919 % 1009 / 1009.0);
        samples[1].push_back(i * 104729 % 997 / 997.0 + 0.05);
        samples[2].push_back(i * 3571 % 500 / 50 / 10.0);
    }
    EXPECT_NEAR(kruskalWallis(samples).h, 7.388281399810124, 1e-10);
    EXPECT_NEAR(kruskalWallis(samples).p, 0.024868814258047593, 1e-12);
}

TEST(RankStatistics, KruskalWallisKnowsItsLimits) {
    EXPECT_EQ(kruskalWallis(Samples{{1, 1}, {1, 1, 1}}).p, 1);
    EXPECT_EQ(kruskalWallis(Samples{{1, 2}, {}}).p, 1);
    EXPECT_EQ(kruskalWallis(Samples{}).p, 1);
    EXPECT_TRUE(std::isnan(kruskalWallis(Samples{{1, NAN}, {2, 3}}).p));
    // Two samples of 2000 values that do not overlap: h = 2999.25, whose p is far below the smallest double.
    Samples apart(2);
    for (int i = 0; i < 2000; ++i) {
        apart[0].push_back(i);
        apart[1].push_back(i + 10000);
    }
    EXPECT_NEAR(kruskalWallis(apart).h, 2999.25, 0.01);
    EXPECT_EQ(kruskalWallis(apart).p, 0);
}

}  // namespace
}  // namespace drc
