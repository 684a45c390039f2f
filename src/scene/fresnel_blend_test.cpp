#include "scene/fresnel_blend.h"

#include "scene/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(FresnelBlend, Sampling) {
    checkSampling(FresnelBlend(Rgb(0.5f), Rgb(0.5f), TrowbridgeReitz(0.2f, 0.2f)));
    checkSampling(FresnelBlend(Rgb(0.2f, 0.5f, 0.1f), Rgb(0.05f), TrowbridgeReitz(0.6f, 0.15f)));
}

TEST(FresnelBlend, EnergyAndReciprocity) {
    for (const float alpha : {0.05f, 0.3f, 0.8f}) {
        const TrowbridgeReitz distribution(alpha, 0.5f * alpha);
        checkEnergy(FresnelBlend(Rgb(1.f), Rgb(0.05f), distribution));
        checkEnergy(FresnelBlend(Rgb(0.5f), Rgb(0.5f), distribution));
        checkReciprocity(FresnelBlend(Rgb(0.5f), Rgb(0.1f, 0.5f, 0.9f), distribution));
    }
}

TEST(FresnelBlend, BaseAlbedoIsExact) {
    // The estimate's base is the integral itself; measured with the coat's own, closed, value of no specular colour.
    const FresnelBlend lobe(Rgb(0.6f), Rgb(0.f), TrowbridgeReitz(0.01f, 0.01f));
    const Vec3 n(0, 0, 1);
    EXPECT_NEAR(furnace(lobe, n, 200000).x, lobe.albedo(n).x, 2e-3f);
}

TEST(FresnelBlend, HandComputed) {
    // Normal incidence: base 28 / (23 pi) 0.5 * 0.5 (31/32)^2, coat D F / 4 = 0.5 / (4 pi 0.25).
    const FresnelBlend lobe(Rgb(0.5f), Rgb(0.5f), TrowbridgeReitz(0.5f, 0.5f));
    const Vec3 n(0, 0, 1);
    EXPECT_NEAR(lobe.f(n, n).x, 28 / (23 * kPi) * 0.25f * sqr(31.f / 32) + 0.5f / kPi, 1e-5f);
}

}  // namespace
}  // namespace drc
