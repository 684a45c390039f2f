#include "scene/textures/noise.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

const Vec3 kPoint(0.3f, 1.7f, -2.6f);

TEST(Noise, IsZeroOnTheLatticeAndFarAway) {
    for (int i = -3; i < 4; ++i) EXPECT_EQ(noise(Vec3(float(i), 7, float(-2 * i))), 0);
    EXPECT_EQ(noise(Vec3(1e30f, 0.5f, 0.5f)), 0);
    EXPECT_EQ(noise(Vec3(std::nanf(""), 0.5f, 0.5f)), 0);
    EXPECT_EQ(noise(Vec3(0.5f, -kInfinity, 0.5f)), 0);
}

// Computed by hand from the published table: the gradients at the corners of the cell at the origin.
TEST(Noise, IsThatOfTheTable) {
    // P[0] = 151, P[151] = 17, P[17] = 36: gradient 36 & 15 = 4 is (1, 0, 1). On the lattice line towards +x the slope
    // at the origin is the gradient's x.
    EXPECT_NEAR(noise(Vec3(1e-3f, 0, 0)) / 1e-3f, 1, 1e-2f);
    EXPECT_NEAR(noise(Vec3(0, 1e-3f, 0)) / 1e-3f, 0, 1e-2f);
    EXPECT_NEAR(noise(Vec3(0, 0, 1e-3f)) / 1e-3f, 1, 1e-2f);
}

TEST(Noise, RepeatsEvery256) {
    for (const Vec3& shift : {Vec3(256, 0, 0), Vec3(0, -512, 0), Vec3(0, 0, 256)})
        EXPECT_NEAR(noise(kPoint + shift), noise(kPoint), 1e-3f);
}

TEST(Noise, IsSmoothAndHasMeanZero) {
    std::mt19937 rng(1);
    std::uniform_real_distribution<float> uniform(-100, 100);
    double sum = 0, sumOfAbsolutes = 0;
    float largest = 0, steepest = 0;
    const int count = 20000;
    for (int i = 0; i < count; ++i) {
        const Vec3 p(uniform(rng), uniform(rng), uniform(rng));
        const float value = noise(p);
        sum += value;
        sumOfAbsolutes += std::abs(value);
        largest = std::max(largest, std::abs(value));
        // Half of the steps cross a lattice plane, where there must be no discontinuity.
        const Vec3 q(std::round(p.x), p.y, p.z);
        steepest = std::max(steepest, std::abs(noise(q + Vec3(1e-3f, 0, 0)) - noise(q - Vec3(1e-3f, 0, 0))) / 2e-3f);
    }
    EXPECT_NEAR(sum / count, 0, 0.01);
    EXPECT_NEAR(sumOfAbsolutes / count, 0.2, 0.02);  // the mean that turbulence() substitutes for octaves left out
    EXPECT_LT(largest, 1.1f);
    EXPECT_GT(largest, 0.7f);
    EXPECT_LT(steepest, 3);
}

TEST(Fbm, SumsItsOctaves) {
    const Vec3 none(0.f);
    EXPECT_EQ(fbm(kPoint, none, none, {1, 0.5f}), noise(kPoint));
    EXPECT_NEAR(fbm(kPoint, none, none, {2, 0.25f}), noise(kPoint) + 0.25f * noise(kPoint * 1.99f), 1e-6f);
    EXPECT_EQ(fbm(kPoint, none, none, {0, 0.5f}), 0);
    EXPECT_NEAR(turbulence(kPoint, none, none, {1, 0}), std::abs(noise(kPoint)), 1e-6f);
    EXPECT_NEAR(turbulence(kPoint, none, none, {2, 0.5f}),
                std::abs(noise(kPoint)) + 0.5f * std::abs(noise(kPoint * 1.99f)) + 0.25f * 0.2f, 1e-6f);
}

TEST(Fbm, LeavesOutWhatTheFootprintDoesNotResolve) {
    const Vec3 none(0.f), wide(0, 3, 0);
    const NoiseSum sum;
    EXPECT_EQ(fbm(kPoint, wide, none, sum), 0);
    EXPECT_EQ(fbm(kPoint, none, wide, sum), 0);
    // The octave of frequency 1 has features of size 1: a footprint of 1/4 resolves it, and not that of 2 in full.
    EXPECT_EQ(fbm(kPoint, Vec3(0.25f, 0, 0), none, sum), noise(kPoint));
    float mean = 0;
    for (float a = 1, i = 0; i < 9; ++i, a *= 0.5f) mean += 0.2f * a;
    EXPECT_NEAR(turbulence(kPoint, wide, none, sum), mean, 1e-6f);
}

TEST(Fbm, ChangesWithTheFootprintWithoutSteps) {
    const NoiseSum sum{6, 0.6f};
    float lastFbm = fbm(kPoint, Vec3(0.001f, 0, 0), Vec3(0.f), sum);
    float lastTurbulence = turbulence(kPoint, Vec3(0.001f, 0, 0), Vec3(0.f), sum);
    for (float width = 0.001f; width < 2; width *= 1.005f) {
        const Vec3 d(width, 0, 0);
        const float nextFbm = fbm(kPoint, d, Vec3(0.f), sum), nextTurbulence = turbulence(kPoint, Vec3(0.f), d, sum);
        EXPECT_NEAR(nextFbm, lastFbm, 0.03f) << width;
        EXPECT_NEAR(nextTurbulence, lastTurbulence, 0.03f) << width;
        lastFbm = nextFbm;
        lastTurbulence = nextTurbulence;
    }
}

}  // namespace
}  // namespace drc
