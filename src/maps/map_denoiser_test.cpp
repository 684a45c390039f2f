#include "maps/map_denoiser.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace drc {
namespace {

double energy(const std::vector<float>& radiance, const MapLayout& layout, size_t channel) {
    double sum = 0;
    for (int i = 0; i < layout.texels(); ++i)
        sum += double(layout.solidAngle(i / layout.size())) * radiance[channel * size_t(layout.texels()) + size_t(i)];
    return sum;
}

CapturedMap noisyMap(const MapLayout& layout, int seed) {
    CapturedMap map;
    const auto texels = size_t(layout.texels());
    map.radiance.resize(3 * texels);
    map.normal.resize(3 * texels, 0.5f);
    map.distance.resize(texels, 1.f);
    std::mt19937 rng{unsigned(seed)};
    std::exponential_distribution<float> e(1);
    for (float& r : map.radiance) r = e(rng);
    return map;
}

TEST(MapDenoiser, GaussianKeepsTheEnergyOfEachChannel) {
    for (const Projection p : {Projection::EqualArea, Projection::LatLong}) {
        const MapLayout layout(p, 32);
        std::vector<CapturedMap> maps{noisyMap(layout, 1), noisyMap(layout, 2)};
        const std::vector<CapturedMap> before = maps;
        makeGaussianMapDenoiser(1)->denoise(maps, layout);
        for (size_t m = 0; m < 2; ++m)
            for (size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(energy(maps[m].radiance, layout, c) / energy(before[m].radiance, layout, c), 1, 1e-5);
    }
}

TEST(MapDenoiser, GaussianSpreadsASingleTexelAsANormalDistribution) {
    const MapLayout layout(Projection::EqualArea, 32);
    CapturedMap map = noisyMap(layout, 1);
    std::fill(map.radiance.begin(), map.radiance.end(), 0.f);
    map.radiance[16 * 32 + 16] = 1;
    makeGaussianMapDenoiser(1)->denoise({&map, 1}, layout);
    // Weights of a normal distribution at whole sigmas, normalised over +-3.
    EXPECT_NEAR(map.radiance[16 * 32 + 16], 0.15924f, 1e-4f);
    EXPECT_NEAR(map.radiance[16 * 32 + 17], 0.09659f, 1e-4f);
    EXPECT_NEAR(map.radiance[17 * 32 + 17], 0.05858f, 1e-4f);
    EXPECT_NEAR(map.radiance[16 * 32 + 18], 0.02155f, 1e-4f);
}

TEST(MapDenoiser, NoneChangesNothing) {
    const MapLayout layout(Projection::EqualArea, 32);
    CapturedMap map = noisyMap(layout, 1);
    const std::vector<float> before = map.radiance;
    makeIdentityMapDenoiser()->denoise({&map, 1}, layout);
    EXPECT_EQ(map.radiance, before);
}

// One texel of a channel is all that a network left, from everything down to less than any float can hold.
TEST(MapDenoiser, EnergyIsKeptAndNoTexelGetsAllOfItHoweverLittleIsLeft) {
    for (const float unit : {1e-12f, 1.f, 1e12f})  // scenes may have any unit of light
        for (const Projection p : {Projection::EqualArea, Projection::LatLong}) {
            const MapLayout layout(p, 8);
            const std::vector<float> captured(3 * 64, unit);
            for (float left = 64; left > 0; left /= 8) {
                SCOPED_TRACE(testing::Message() << projectionName(p) << " unit " << unit << " left " << left);
                std::vector<float> radiance(3 * 64, 0.f);
                for (size_t c = 0; c < 3; ++c) radiance[c * 64 + 28] = left * unit;
                matchEnergy(captured, layout, radiance);
                for (size_t c = 0; c < 3; ++c)
                    ASSERT_NEAR(energy(radiance, layout, c) / energy(captured, layout, c), 1, 1e-5);
                ASSERT_LE(radiance[28], 1.001f * unit * (kMostGain * left + 1));
                ASSERT_GE(*std::min_element(radiance.begin(), radiance.end()), 0.f);
            }
        }
}

TEST(MapDenoiser, TheGainsBoundIsNoStep) {
    const MapLayout layout(Projection::EqualArea, 8);
    const std::vector<float> captured(3 * 64, 1.f);
    std::vector<float> below(3 * 64, 0.f), above(3 * 64, 0.f);
    for (size_t c = 0; c < 3; ++c) {
        below[c * 64 + 9] = 64 / kMostGain * 1.0001f;
        above[c * 64 + 9] = 64 / kMostGain * 0.9999f;
    }
    matchEnergy(captured, layout, below);
    matchEnergy(captured, layout, above);
    for (size_t i = 0; i < above.size(); ++i) EXPECT_NEAR(above[i], below[i], 0.02f);
}

TEST(MapDenoiser, ChannelsAreMatchedByThemselves) {
    const MapLayout layout(Projection::EqualArea, 8);
    CapturedMap map = noisyMap(layout, 3);
    std::vector<float> captured = map.radiance;
    for (size_t i = 128; i < 192; ++i) captured[i] *= 1e-8f;  // a red and green scene
    matchEnergy(captured, layout, map.radiance);
    for (size_t i = 0; i < captured.size(); ++i) EXPECT_NEAR(map.radiance[i], captured[i], 1e-5f * captured[i]);
}

TEST(MapDenoiser, WhatIsNoNumberBecomesTheMean) {
    const MapLayout layout(Projection::EqualArea, 8);
    const std::vector<float> captured(3 * 64, 2.f);
    std::vector<float> radiance(3 * 64, 1.f);
    radiance[3] = std::numeric_limits<float>::quiet_NaN();
    radiance[70] = std::numeric_limits<float>::infinity();
    matchEnergy(captured, layout, radiance);
    for (const float r : radiance) EXPECT_NEAR(r, 2, 1e-5f);
}

TEST(MapDenoiser, EnergyThatANetworkBlackenedIsSpreadEvenly) {
    const MapLayout layout(Projection::EqualArea, 8);
    std::vector<float> captured(3 * 64, 0.f), black(3 * 64, 0.f);
    captured[5] = 64;
    matchEnergy(captured, layout, black);
    EXPECT_NEAR(black[0], 1, 1e-5f);
    EXPECT_NEAR(black[63], 1, 1e-5f);
    EXPECT_EQ(black[64], 0);
}

}  // namespace
}  // namespace drc
