#include "maps/projection.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "transport/path_tracer.h"

namespace drc {
namespace {

class EveryProjection : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(Projection, EveryProjection, testing::Values(Projection::EqualArea, Projection::LatLong),
                         [](const auto& i) { return i.param == Projection::EqualArea ? "EqualArea" : "LatLong"; });

TEST_P(EveryProjection, TexelOfADirectionIsTheTexelItCameFrom) {
    const MapLayout layout(GetParam(), 32);
    std::mt19937 rng(1);
    std::uniform_real_distribution<float> u(0.01f, 0.99f);
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column) {
            const Vec3 d = layout.direction(column, row, Vec2(u(rng), u(rng)));
            EXPECT_NEAR(length(d), 1, 1e-5f);
            EXPECT_GE(d.z, 0);
            EXPECT_EQ(layout.texel(d), row * 32 + column);
        }
}

TEST_P(EveryProjection, SolidAnglesSumToTheHemisphere) {
    for (const int n : {8, 32, 64}) {
        const MapLayout layout(GetParam(), n);
        double sum = 0;
        for (int row = 0; row < n; ++row) sum += double(layout.solidAngle(row)) * n;
        EXPECT_NEAR(sum, 2 * std::numbers::pi, 1e-5);
    }
}

// Uniformly distributed directions must fall into each texel in proportion to its solid angle.
TEST_P(EveryProjection, SolidAngleIsThatOfTheTexel) {
    const int n = 8, samples = 400000;
    const MapLayout layout(GetParam(), n);
    std::vector<int> counts(size_t(n * n));
    std::mt19937 rng(2);
    std::uniform_real_distribution<float> u(0, 1);
    for (int i = 0; i < samples; ++i) {
        const float z = u(rng), phi = 2 * kPi * u(rng), r = safeSqrt(1 - z * z);
        ++counts[size_t(layout.texel(Vec3(r * std::cos(phi), r * std::sin(phi), z)))];
    }
    double chiSquare = 0;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const double expected = samples * layout.solidAngle(row) / (2 * std::numbers::pi);
            chiSquare += sqr(float(counts[size_t(row * n + column)] - expected)) / expected;
        }
    // Chi-square with 63 degrees of freedom has the mean 63 and the standard deviation 11.2; five of those are allowed.
    EXPECT_LT(chiSquare, 63 + 5 * 11.2);
}

// Over all texels, the mean cosine of the sampled directions weighted by solid angle must be that of the hemisphere,
// 1/2.
TEST_P(EveryProjection, DirectionsAreUniformInsideATexel) {
    const MapLayout layout(GetParam(), 4);
    double sum = 0;
    const int sub = 32;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            for (int i = 0; i < sub * sub; ++i) {
                const Vec2 u((float(i % sub) + 0.5f) / sub, (float(i / sub) + 0.5f) / sub);
                sum += double(layout.direction(column, row, u).z) * layout.solidAngle(row) / (sub * sub);
            }
    EXPECT_NEAR(sum, std::numbers::pi, 2e-3);
}

TEST_P(EveryProjection, BelowTheHorizonIsTheHorizon) {
    const MapLayout layout(GetParam(), 32);
    for (int i = 0; i < 64; ++i) {
        const float phi = 2 * kPi * float(i) / 64;
        const Vec3 above = normalize(Vec3(std::cos(phi), std::sin(phi), 1e-4f));
        const Vec3 below = normalize(Vec3(std::cos(phi), std::sin(phi), -0.2f));
        const auto centre = [&](const Vec3& d) {
            const int texel = layout.texel(d);
            return layout.direction(texel % 32, texel / 32, Vec2(0.5f, 0.5f));
        };
        // The two centres are within two texels of each other.
        EXPECT_GT(dot(centre(above), centre(below)), std::cos(0.2f)) << phi;
    }
}

TEST(Projection, CoarserMapsResolveRougherLobes) {
    for (const Projection p : {Projection::EqualArea, Projection::LatLong}) {
        EXPECT_EQ(broadAlpha(MapLayout(p, 32)), PathSettings().broadAlpha);
        EXPECT_FLOAT_EQ(broadAlpha(MapLayout(p, 16)), 0.4f);
        EXPECT_FLOAT_EQ(broadAlpha(MapLayout(p, 64)), 0.1f);
    }
}

TEST_P(EveryProjection, TexelsHaveTheirMeanSolidAngle) {
    const MapLayout layout(GetParam(), 16);
    double sum = 0;
    for (int row = 0; row < 16; ++row) sum += 16 * double(layout.solidAngle(row));
    EXPECT_NEAR(layout.meanSolidAngle(), sum / 256, 1e-6);
}

TEST(Projection, NamesRoundTrip) {
    EXPECT_EQ(projectionFromName("latlong"), Projection::LatLong);
    EXPECT_EQ(projectionFromName("equal-area"), Projection::EqualArea);
    EXPECT_THROW(projectionFromName("mercator"), Error);
}

// The paper's convention: the normal is the map's centre, u = 0 is +x, v = 0 is +y.
TEST(Projection, LatLongHasTheNormalAtItsCentre) {
    const MapLayout layout(Projection::LatLong, 32);
    const Vec3 centre = layout.direction(16, 16, Vec2(0, 0));
    EXPECT_NEAR(centre.z, 1, 1e-6f);
    EXPECT_NEAR(layout.direction(0, 16, Vec2(0, 0)).x, 1, 1e-6f);
    EXPECT_NEAR(layout.direction(16, 0, Vec2(0, 0)).y, 1, 1e-6f);
}

}  // namespace
}  // namespace drc
