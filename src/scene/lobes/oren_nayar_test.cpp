#include "scene/lobes/oren_nayar.h"

#include "scene/lobes/lambert_reflection.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

constexpr DiffusePart kParts[] = {DiffusePart::Separable, DiffusePart::Rest};

// The value of both parts together.
Rgb sum(const Rgb& reflectance, float sigma, const Vec3& wo, const Vec3& wi) {
    Rgb f(0.f);
    for (const DiffusePart part : kParts) f += OrenNayar(reflectance, sigma, part).f(wo, wi);
    return f;
}

TEST(OrenNayar, Sampling) {
    for (const DiffusePart part : kParts) checkSampling(OrenNayar(Rgb(0.7f), 30, part));
}

TEST(OrenNayar, EnergyReciprocityAndAlbedo) {
    for (const float sigma : {5.f, 20.f, 60.f}) {
        const OrenNayar even(Rgb(1.f), sigma, DiffusePart::Separable), grooves(Rgb(1.f), sigma, DiffusePart::Rest);
        for (float c = -0.95f; c < 1; c += 0.1f)
            EXPECT_LE(furnace(even, direction(c)).x + furnace(grooves, direction(c)).x, 1.01f) << c;
        for (const OrenNayar& lobe : {even, grooves}) {
            checkReciprocity(lobe);
            checkAlbedo(lobe, 4e-3f);
        }
    }
}

TEST(OrenNayar, TheEvenPartIsSeparable) {
    const OrenNayar even(Rgb(0.7f, 0.5f, 0.2f), 40, DiffusePart::Separable);
    EXPECT_TRUE(even.isSeparable());
    EXPECT_FALSE(OrenNayar(Rgb(0.7f), 40, DiffusePart::Rest).isSeparable());
    checkSeparable(even);
}

TEST(OrenNayar, WithoutRoughnessIsLambertian) {
    std::mt19937 rng(1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        expectClose(sum(Rgb(0.5f), 0, wo, wi), LambertReflection(Rgb(0.5f)).f(wo, wi), 1e-6f);
    }
}

TEST(OrenNayar, HandComputed) {
    // sigma = 20 degrees: sigma^2 = 0.1218470, A = 0.8651797, B = 0.2588238 (0.45 * 0.1218470 / 0.2118470).
    // theta_i = 60, theta_o = 30 in the same azimuth: sin alpha = sin 60, tan beta = tan 30, product 1/2.
    const Vec3 wi(std::sqrt(0.75f), 0, 0.5f), wo(0.5f, 0, std::sqrt(0.75f));
    EXPECT_NEAR(sum(Rgb(1.f), 20, wo, wi).x, kInvPi * (0.8651797f + 0.5f * 0.2588238f), 1e-5f);
    // In opposite azimuths only A is left.
    EXPECT_NEAR(sum(Rgb(1.f), 20, Vec3(-0.5f, 0, std::sqrt(0.75f)), wi).x, kInvPi * 0.8651797f, 1e-5f);
}

}  // namespace
}  // namespace drc
