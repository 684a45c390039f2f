// Helpers for tests of point lights.
#pragma once
#include <gtest/gtest.h>

#include "math/warp.h"
#include "scene/lights/light.h"

namespace drc::test {

// Intensity towards the unit vector w, W / sr. Measured at a distance other than 1, so that d and d^2 cannot be
// confused.
inline Rgb intensityTowards(const Light& light, const Vec3& w) {
    constexpr float kDistance = 3;
    const Vec3 center = light.bounds().center();
    const auto s = light.sample(center + w * kDistance, Vec2(0.5f, 0.5f));
    if (!s) return Rgb(0.f);
    EXPECT_LT(length(s->wi + w), 1e-4f);
    EXPECT_NEAR(s->distance, kDistance, 1e-4);
    EXPECT_TRUE(s->delta && s->pdf == 1);
    return s->radiance * sqr(kDistance);
}

// Checks that the flux through a sphere around the light is its power, that reach() excludes no direction in which it
// emits, and that it does not overestimate any of them.
inline void checkPowerAndReach(const Light& light, float tolerance) {
    constexpr int kSide = 400;
    double sum[3] = {0, 0, 0};
    const LightReach reach = light.reach();
    const float cosLimit = std::cos(std::min(kPi, reach.spread + reach.falloff + 1e-3f));
    float brightest = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const Vec3 w = sampleUniformSphere(Vec2((float(i) + 0.5f) / kSide, (float(j) + 0.5f) / kSide));
            const Rgb intensity = intensityTowards(light, w);
            brightest = std::max(brightest, luminance(intensity));
            for (int c = 0; c < 3; ++c) sum[c] += double(intensity[c]);
            if (!isBlack(intensity)) {
                ASSERT_GE(dot(w, reach.axis), cosLimit);
            }
        }
    const Rgb power = light.power(1);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(power[c] / (sum[c] * 4 * std::numbers::pi / (kSide * kSide)), 1, tolerance) << "channel " << c;
    EXPECT_GT(reach.intensity, 0);
    EXPECT_LE(reach.intensity, 1.01f * brightest);
}

}  // namespace drc::test
