#include "scene/lobes/dielectric_coat.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/lobes/microfacet.h"

namespace drc {
namespace {

using namespace test;

TEST(DielectricCoat, SmoothIsFresnels) {
    const DielectricCoat coat(1.5f, 0, 0);
    for (const float c : {1.f, 0.5f, 0.1f}) {
        EXPECT_NEAR(coat.reflectance(c), fresnelDielectric(c, 1, 1.5f), 1e-5f);
        EXPECT_NEAR(coat.transmittance(c), 1 - fresnelDielectric(c, 1, 1.5f), 1e-5f);
        EXPECT_NEAR(coat.cosineInside(c), std::sqrt(1 - (1 - c * c) / 2.25f), 1e-6f);
    }
    // Tabulated hemispherical reflectances for an index of 1.5, from outside and inside.
    EXPECT_NEAR(1 - coat.meanTransmittance(), 0.0918f, 2e-4f);
    EXPECT_NEAR(coat.internalReflectance(), 0.5963f, 2e-4f);
}

TEST(DielectricCoat, WhatEntersCanLeave) {
    // Diffuse light on both sides is in equilibrium: eta^2 (1 - internal reflectance) = mean transmittance.
    for (const float eta : {1.f, 1.3f, 1.5f, 2.4f})
        for (const float alpha : {0.f, 0.1f, 0.5f, 1.f}) {
            const DielectricCoat coat(eta, alpha, 0);
            EXPECT_NEAR(sqr(eta) * (1 - coat.internalReflectance()), coat.meanTransmittance(), 1e-4f);
        }
    EXPECT_NEAR(DielectricCoat(1, 0.3f, 0).internalReflectance(), 0, 1e-5f);
}

TEST(DielectricCoat, RoughIsTheMeanOverVisibleNormals) {
    for (const float eta : {1.3f, 1.5f, 2.f})
        for (const float alpha : {0.05f, 0.2f, 0.4f, 1.f})
            for (const float c : {0.1f, 0.4f, 0.9f}) {
                const TrowbridgeReitz distribution(alpha, alpha);
                const Vec3 wo = direction(c);
                std::mt19937 rng(6);
                double sum = 0;
                constexpr int kSamples = 4000;
                for (int i = 0; i < kSamples; ++i)
                    sum += fresnelDielectric(dot(wo, distribution.sample(wo, uniform2(rng))), 1, eta);
                EXPECT_NEAR(DielectricCoat(eta, alpha, 0).reflectance(c), sum / kSamples, 0.03f)
                    << eta << " " << alpha << " " << c;
            }
}

TEST(DielectricCoat, Absorbs) {
    const DielectricCoat coat(1.5f, 0, 0.4f);
    EXPECT_NEAR(coat.passed(0.8f), std::exp(-0.5f), 1e-6f);
    EXPECT_NEAR(coat.transmittance(1), 0.96f * std::exp(-0.4f), 1e-5f);
    EXPECT_LT(coat.internalReflectance(), DielectricCoat(1.5f, 0, 0).internalReflectance());
    // Light needs to pass at least the depth along the normal twice, which leaves at most exp(-0.8).
    EXPECT_LT(coat.internalReflectance(), 0.5963f * std::exp(-0.8f));
}

}  // namespace
}  // namespace drc
