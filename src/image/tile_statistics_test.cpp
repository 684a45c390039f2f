#include "image/tile_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace drc {
namespace {

struct Moments {
    double mean = 0, deviation = 0;
};
Moments momentsOf(const std::vector<double>& values) {
    Moments m;
    for (const double v : values) m.mean += v / double(values.size());
    for (const double v : values) m.deviation += (v - m.mean) * (v - m.mean) / double(values.size() - 1);
    m.deviation = std::sqrt(m.deviation);
    return m;
}

// White noise, averaged over `width` neighbours each way, on a slope.
Plane field(std::mt19937& rng, int width, float slope) {
    constexpr int kSide = 160;
    Plane white(kSide, kSide);
    std::normal_distribution<float> normal;
    for (float& v : white.values) v = normal(rng);
    const Kernel box(size_t(2 * width + 1), 1 / float(2 * width + 1));
    Plane result = convolve(white, box, box);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) result.at(x, y) += slope * float(x) / kSide;
    return result;
}

// What it says of one picture is how far the means of many lie apart.
TEST(TileStatistics, StandardErrorIsTheSpreadOfMeans) {
    std::mt19937 rng(7);
    for (const int width : {0, 2, 4}) {
        std::vector<double> means, errors;
        for (int i = 0; i < 200; ++i) {
            const Estimate estimate = meanOverTiles(field(rng, width, 0.3f), 20);
            means.push_back(estimate.mean), errors.push_back(estimate.standardError);
        }
        const double ratio = momentsOf(errors).mean / momentsOf(means).deviation;
        EXPECT_GT(ratio, 0.8) << width;
        EXPECT_LT(ratio, 1.25) << width;
        EXPECT_NEAR(momentsOf(means).mean, 0.15, 4 * momentsOf(means).deviation / std::sqrt(200.)) << width;
    }
}

// Pixels taken as independent would say a ninth of it.
TEST(TileStatistics, OfCorrelatedPixelsIsLargerThanThatOfAsManyIndependentOnes) {
    std::mt19937 rng(3);
    const Plane plane = field(rng, 4, 0);
    double square = 0;
    for (const float v : plane.values) square += double(v) * v;
    const double naive = std::sqrt(square) / double(plane.values.size());
    EXPECT_GT(meanOverTiles(plane, 20).standardError, 5 * naive);
}

TEST(TileStatistics, OfZeroHasNoNeedOfDifferences) {
    std::mt19937 rng(5);
    std::vector<double> means, errors;
    for (int i = 0; i < 200; ++i) {
        const Plane plane = field(rng, 1, 0);
        means.push_back(meanOverTiles(plane, 20).mean);
        errors.push_back(standardErrorOfZero(plane, 20));
    }
    EXPECT_NEAR(momentsOf(errors).mean / momentsOf(means).deviation, 1, 0.15);
}

TEST(TileStatistics, LeavesOutNan) {
    Plane plane(20, 16);
    for (float& v : plane.values) v = 2;
    plane.at(3, 3) = NAN;
    EXPECT_EQ(meanOverTiles(plane, 8).mean, 2);
    EXPECT_NEAR(meanOverTiles(plane, 8).standardError, 0, 1e-12);
    for (float& v : plane.values) v = NAN;
    EXPECT_TRUE(std::isnan(meanOverTiles(plane, 8).mean));
    EXPECT_TRUE(std::isnan(standardErrorOfZero(plane, 8)));
    EXPECT_TRUE(std::isnan(meanOverTiles(Plane(8, 8), 8).standardError));
}

TEST(TileStatistics, TilesOfUsersPicturesHave32Pixels) {
    EXPECT_EQ(tileSide(1280, 720), 32);
    EXPECT_EQ(tileSide(160, 90), 15);
    EXPECT_EQ(tileSide(64, 48), 8);
    EXPECT_EQ(tileSide(1, 1), 8);
}

}  // namespace
}  // namespace drc
