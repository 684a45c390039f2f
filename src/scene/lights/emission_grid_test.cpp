#include "scene/lights/emission_grid.h"

#include <gtest/gtest.h>

#include "math/rank_statistics.h"
#include "math/rng.h"

namespace drc {
namespace {

EmissionImage shown(int width, int height, const std::function<Rgb(int x, int y)>& texel) {
    LightImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.texels.push_back(texel(x, y));
    return EmissionImage(std::move(image));
}
EmissionImage patches(int width, int height) {
    Pcg32 rng(7);
    return shown(width, height, [&](int, int) {
        const float on = rng.nextFloat(), value = rng.nextFloat();
        return on < 0.5f ? Rgb(0.f) : Rgb(value, value * value, 1 - value);
    });
}

// Patches: the image upright; turned, and beyond its edges; bent, with areas that vary.
const struct {
    const char* name;
    Patch patch;
} kPatches[] = {
    {"upright", [](const Vec2& at) { return PatchPoint{at}; }},
    {"turned",
     [](const Vec2& at) { return PatchPoint{Vec2(0.8f * at.x - 0.9f * at.y + 0.4f, 0.7f * at.x + at.y - 0.2f)}; }},
    {"bent",
     [](const Vec2& at) {
         return PatchPoint{at, std::sin(kPi * at.y)};
     }},
};

TEST(EmissionGrid, SamplesFollowTheDensityAndFindAllLight) {
    const EmissionImage image = patches(19, 13);
    for (const auto& [name, patch] : kPatches) {
        const EmissionGrid grid(image, 19, 13, patch);
        ASSERT_FALSE(grid.isUniform()) << name;
        // Chi-square, over cells that are not the grid's.
        constexpr int kColumns = 8, kRows = 8, kSamples = 40000, kFine = 64;
        std::vector<double> observed(kColumns * kRows), expected(kColumns * kRows);
        Pcg32 rng(2);
        double flux[3] = {}, sum[3] = {}, squares[3] = {};
        for (int i = 0; i < kSamples; ++i) {
            const EmissionGrid::Sample s = grid.sample(rng.nextVec2());
            ASSERT_GT(s.density, 0);
            ++observed[size_t(int(s.at.y * kRows) * kColumns + int(s.at.x * kColumns))];
            const PatchPoint at = patch(s.at);
            const Rgb value = image.lookup(at.uv) * (at.area / s.density);
            for (int c = 0; c < 3; ++c) {
                sum[c] += double(value[c]) / kSamples;
                squares[c] += double(value[c] * value[c]) / kSamples;
            }
        }
        double total = 0;
        for (int y = 0; y < kRows * kFine; ++y)
            for (int x = 0; x < kColumns * kFine; ++x) {
                const Vec2 at((float(x) + 0.5f) / (kColumns * kFine), (float(y) + 0.5f) / (kRows * kFine));
                const PatchPoint point = patch(at);
                const Rgb radiance = image.lookup(point.uv);
                const double density = double(grid.density(at)) / (kColumns * kRows * kFine * kFine);
                if (!isBlack(radiance)) {
                    ASSERT_GT(density, 0) << name;
                }
                total += density;
                expected[size_t(y / kFine * kColumns + x / kFine)] += density * kSamples;
                for (int c = 0; c < 3; ++c)
                    flux[c] += double(radiance[c] * point.area) / (kColumns * kRows * kFine * kFine);
            }
        EXPECT_NEAR(total, 1, 2e-3) << name;
        double chi2 = 0;
        for (size_t i = 0; i < observed.size(); ++i)
            chi2 += (observed[i] - expected[i]) * (observed[i] - expected[i]) / std::max(1.0, expected[i]);
        EXPECT_GT(chiSquareUpperTail(chi2, kColumns * kRows - 1), 1e-4) << name << ": " << chi2;
        for (int c = 0; c < 3; ++c) {
            const double sigma = std::sqrt((squares[c] - sum[c] * sum[c]) / kSamples);
            EXPECT_NEAR(sum[c], flux[c], 4.5 * sigma) << name;
            EXPECT_NEAR(grid.integral()[c], flux[c], 5e-3 * flux[c]) << name;
        }
        EXPECT_NEAR(grid.weight(), double(luminance(grid.integral())), 0.02 * grid.weight()) << name;
    }
}

TEST(EmissionGrid, OneBrightPixelGetsItsShare) {
    const auto image = shown(64, 64, [](int x, int y) { return Rgb(x == 40 && y == 10 ? 4096.f : 1.f); });
    const EmissionGrid grid(image, 64, 64, kPatches[0].patch);
    Pcg32 rng(1);
    int near = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec2 at = grid.sample(rng.nextVec2()).at * 64.f - Vec2(40.5f, 10.5f);
        near += std::abs(at.x) < 1.5f && std::abs(at.y) < 1.5f;
    }
    // Half of the flux is its own, and interpolation spreads it over its neighbours.
    EXPECT_NEAR(near, 2000, 200);
}

TEST(EmissionGrid, WhatHardlyVariesIsUniform) {
    const auto smooth = shown(32, 32, [](int x, int) { return Rgb(1 + 0.001f * float(x)); });
    EXPECT_TRUE(EmissionGrid(smooth, 32, 32, kPatches[0].patch).isUniform());
    // Also where the area of the square varies.
    const EmissionGrid bent(smooth, 32, 32, kPatches[2].patch);
    EXPECT_TRUE(bent.isUniform());
    EXPECT_NEAR(bent.weight(), 2 / std::numbers::pi * 1.0155, 1e-3);
}

TEST(EmissionGrid, SmallTablesForLargeImages) {
    const auto image = shown(300, 200, [](int x, int y) { return Rgb(x > 290 && y > 190 ? 1.f : 0.f); });
    const EmissionGrid grid(image, 300, 200, kPatches[0].patch, 500);
    EXPECT_LE(grid.cellCount(), 500);
    EXPECT_FALSE(grid.isUniform());
    Pcg32 rng(1);
    int lit = 0;
    for (int i = 0; i < 1000; ++i) lit += !isBlack(image.lookup(grid.sample(rng.nextVec2()).at));
    EXPECT_GT(lit, 200);  // of a lit area of 0.15 %
    EXPECT_TRUE(EmissionGrid(shown(2, 2, [](int, int) { return Rgb(0.f); }), 2, 2, kPatches[0].patch).isUniform());
    EXPECT_EQ(EmissionGrid(shown(2, 2, [](int, int) { return Rgb(0.f); }), 2, 2, kPatches[0].patch).weight(), 0);
}

}  // namespace
}  // namespace drc
