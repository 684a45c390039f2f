#include "scene/oren_nayar.h"

#include "scene/lambert_reflection.h"
#include "scene/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(OrenNayar, Sampling) { checkSampling(OrenNayar(Rgb(0.7f), 30)); }

TEST(OrenNayar, EnergyAndReciprocity) {
    for (const float sigma : {5.f, 20.f, 60.f}) {
        checkEnergy(OrenNayar(Rgb(1.f), sigma));
        checkReciprocity(OrenNayar(Rgb(1.f, 0.3f, 0.1f), sigma));
    }
}

TEST(OrenNayar, WithoutRoughnessIsLambertian) {
    std::mt19937 rng(1);
    const OrenNayar lobe(Rgb(0.5f), 0);
    for (int i = 0; i < 100; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        expectClose(lobe.f(wo, wi), LambertReflection(Rgb(0.5f)).f(wo, wi), 1e-6f);
    }
}

TEST(OrenNayar, HandComputed) {
    // sigma = 20 degrees: sigma^2 = 0.1218470, A = 0.8651797, B = 0.2588238 (0.45 * 0.1218470 / 0.2118470).
    // theta_i = 60, theta_o = 30 in the same azimuth: sin alpha = sin 60, tan beta = tan 30, product 1/2.
    const Vec3 wi(std::sqrt(0.75f), 0, 0.5f), wo(0.5f, 0, std::sqrt(0.75f));
    EXPECT_NEAR(OrenNayar(Rgb(1.f), 20).f(wo, wi).x, kInvPi * (0.8651797f + 0.5f * 0.2588238f), 1e-5f);
    // In opposite azimuths only A is left.
    EXPECT_NEAR(OrenNayar(Rgb(1.f), 20).f(Vec3(-0.5f, 0, std::sqrt(0.75f)), wi).x, kInvPi * 0.8651797f, 1e-5f);
}

}  // namespace
}  // namespace drc
