#include "scene/lobes/fresnel_blend.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(FresnelBlend, Sampling) {
    checkSampling(FresnelBlendBase(Rgb(0.2f, 0.5f, 0.1f), Rgb(0.05f)));
    checkSampling(FresnelBlendCoat(Rgb(0.5f), TrowbridgeReitz(0.2f, 0.2f)));
    checkSampling(FresnelBlendCoat(Rgb(0.05f), TrowbridgeReitz(0.6f, 0.15f)));
}

TEST(FresnelBlend, EnergyAndReciprocity) {
    checkReciprocity(FresnelBlendBase(Rgb(0.5f), Rgb(0.1f, 0.5f, 0.9f)));
    for (const float alpha : {0.05f, 0.3f, 0.8f}) {
        const TrowbridgeReitz distribution(alpha, 0.5f * alpha);
        checkReciprocity(FresnelBlendCoat(Rgb(0.1f, 0.5f, 0.9f), distribution));
        // Base and coat together must not reflect more light than arrives.
        for (const float cosTheta : {1.f, 0.7f, 0.3f}) {
            const Vec3 wo(safeSqrt(1 - sqr(cosTheta)), 0, cosTheta);
            const float base = furnace(FresnelBlendBase(Rgb(1.f), Rgb(0.05f)), wo, 20000).x;
            const float coat = furnace(FresnelBlendCoat(Rgb(0.05f), distribution), wo, 20000).x;
            EXPECT_LE(base + coat, 1.01f) << "alpha " << alpha << ", cosine " << cosTheta;
        }
    }
}

TEST(FresnelBlend, BaseIsSeparable) { checkSeparable(FresnelBlendBase(Rgb(0.8f, 0.5f, 0.2f), Rgb(0.3f))); }

TEST(FresnelBlend, BaseAlbedoIsExact) {
    const FresnelBlendBase lobe(Rgb(0.6f), Rgb(0.3f));
    for (const float cosTheta : {1.f, 0.5f, 0.1f}) {
        const Vec3 wo(safeSqrt(1 - sqr(cosTheta)), 0, cosTheta);
        EXPECT_NEAR(furnace(lobe, wo, 200000).x, lobe.albedo(wo).x, 2e-3f);
    }
}

TEST(FresnelBlend, HandComputed) {
    // Normal incidence: base 28 / (23 pi) 0.5 * 0.5 (31/32)^2, coat D F / 4 = 0.5 / (4 pi 0.25).
    const Vec3 n(0, 0, 1);
    EXPECT_NEAR(FresnelBlendBase(Rgb(0.5f), Rgb(0.5f)).f(n, n).x, 28 / (23 * kPi) * 0.25f * sqr(31.f / 32), 1e-5f);
    EXPECT_NEAR(FresnelBlendCoat(Rgb(0.5f), TrowbridgeReitz(0.5f, 0.5f)).f(n, n).x, 0.5f / kPi, 1e-5f);
}

TEST(FresnelBlend, TheCoatTellsTheRougherOfItsAxes) {
    EXPECT_EQ(FresnelBlendCoat(Rgb(0.5f), TrowbridgeReitz(0.3f, 0.1f)).alpha(), 0.3f);
    EXPECT_EQ(FresnelBlendCoat(Rgb(0.5f), TrowbridgeReitz(0.1f, 0.2f)).alpha(), 0.2f);
    EXPECT_EQ(FresnelBlendBase(Rgb(0.5f), Rgb(0.5f)).alpha(), kDiffuseAlpha);
}

}  // namespace
}  // namespace drc
