#include <gtest/gtest.h>

#include <cmath>

#include "math/sampler.h"
#include "scene/lights/light.h"

namespace drc {
namespace {

const Vec3 kDirection = normalize(Vec3(1, 2, 2));

// The sun's own angle, a cloudy sun's, and half of the sky.
class SunLight : public testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(, SunLight, testing::Values(0.53f, 10.f, 90.f, 180.f));

TEST_P(SunLight, IlluminatesLikeADistantLight) {
    const LightPtr light = makeSunLight(kDirection, Rgb(3, 2, 1), GetParam());
    double sum = 0;
    constexpr int kSamples = 1 << 14;
    for (int i = 0; i < kSamples; ++i) {
        const auto s = light->sample(Vec3(0), Sampler(1, uint32_t(i)).get2D());
        ASSERT_TRUE(s && !s->delta);
        EXPECT_NEAR(length(s->wi), 1, 1e-5);
        sum += double(light->escaped(Vec3(0), s->wi).x) * dot(s->wi, kDirection) / s->pdf / kSamples;
    }
    EXPECT_NEAR(sum, 3, 0.01);
    EXPECT_NEAR(light->power(2).x, 3 * 4 * kPi, 1e-3);
}

// What is sampled is seen, with the same density; nothing beyond the edge.
TEST_P(SunLight, HasAnEdge) {
    const LightPtr light = makeSunLight(kDirection, Rgb(1.f), GetParam());
    int missed = 0;
    for (uint32_t i = 0; i < 1000; ++i) {
        const Vec2 u = Sampler(2, i).get2D();
        const auto s = light->sample(Vec3(0), u);
        // Directions on the very edge may round to the other side of it.
        if (light->pdfEscaped(Vec3(0), s->wi) == 0) {
            ++missed;
            continue;
        }
        EXPECT_EQ(light->pdfEscaped(Vec3(0), s->wi), s->pdf);
        const Vec2 back = light->inverse(Vec3(0), s->wi);
        EXPECT_NEAR(back.x, u.x, 2e-3);
        // In the very middle all turns are alike.
        if (u.x > 0.01f) {
            EXPECT_NEAR(std::remainder(back.y - u.y, 1.f), 0, 2e-3);
        }
    }
    EXPECT_LE(missed, 2);
    const Frame frame = Frame::fromNormal(kDirection);
    const float half = GetParam() * kPi / 360;
    const auto at = [&](float angle) { return frame.toWorld(Vec3(std::sin(angle), 0, std::cos(angle))); };
    EXPECT_GT(light->escaped(Vec3(0), at(0.99f * half)).x, 0);
    EXPECT_EQ(light->escaped(Vec3(0), at(1.01f * half)).x, 0);
    EXPECT_EQ(light->pdfEscaped(Vec3(0), at(1.01f * half)), 0);
}

TEST_P(SunLight, EmitsAsItIsSampled) {
    const LightPtr light = makeSunLight(kDirection, Rgb(1.f), GetParam());
    const SceneSphere scene{Vec3(1, 2, 3), 4};
    const auto ray = light->emit(Vec2(0.3f, 0.6f), Vec2(0.2f, 0.9f), scene);
    ASSERT_TRUE(ray);
    const EmissionDensity density = light->emissionDensity({}, ray->d, scene);
    EXPECT_EQ(density.origin, ray->density.origin);
    EXPECT_EQ(density.leaving, ray->density.leaving);
    EXPECT_EQ(ray->radiance, light->escaped(scene.center, -ray->d));
}

}  // namespace
}  // namespace drc
