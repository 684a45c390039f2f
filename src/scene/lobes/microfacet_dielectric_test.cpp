#include "scene/lobes/microfacet_dielectric.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(MicrofacetDielectric, Sampling) {
    checkSampling(MicrofacetDielectric(Rgb(1.f), Rgb(1.f), TrowbridgeReitz(0.15f, 0.15f), 1.5f));
    checkSampling(
        MicrofacetDielectric(Rgb(0.9f, 0.2f, 0.1f), Rgb(0.1f, 0.9f, 0.5f), TrowbridgeReitz(0.7f, 0.3f), 1.5f));
    checkSampling(MicrofacetDielectric(Rgb(1.f), Rgb(0.f), TrowbridgeReitz(0.4f, 0.4f), 1 / 1.4f));
}

TEST(MicrofacetDielectric, IsTheSumOfReflectionAndRefraction) {
    const TrowbridgeReitz distribution(0.4f, 0.2f);
    const Rgb red(0.9f, 0.3f, 0.2f), blue(0.2f, 0.4f, 0.8f);
    const MicrofacetDielectric glass(red, blue, distribution, 1.5f);
    const MicrofacetReflection reflection(red, distribution, Fresnel::dielectric(1, 1.5f));
    const MicrofacetTransmission refraction(blue, distribution, 1, 1.5f);
    for (const float c : {0.9f, 0.3f, -0.3f, -0.8f}) {
        const Rgb parts = furnace(reflection, direction(c), 100000) + furnace(refraction, direction(c), 100000);
        expectClose(furnace(glass, direction(c), 100000), parts, 0.02f, "albedo");
    }
    std::mt19937 rng(1);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = randomDirection(rng), wi = randomDirection(rng);
        for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance})
            EXPECT_EQ(glass.f(wo, wi, mode),
                      sameHemisphere(wo, wi) ? reflection.f(wo, wi) : refraction.f(wo, wi, mode));
    }
}

// The reason for one lobe: inside glass, samples of two lobes that are chosen before the facet is known differ by the
// facets' reflectances, from 4 % to all.
TEST(MicrofacetDielectric, WeightsOfSamplesAreNearlyEqual) {
    const MicrofacetDielectric glass(Rgb(1.f), Rgb(1.f), TrowbridgeReitz(0.2f, 0.2f), 1.5f);
    std::mt19937 rng(1);
    for (const float c : {0.9f, -0.75f, -0.4f})
        for (int i = 0; i < 2000; ++i) {
            const float uLobe = uniform(rng);
            const LobeSample s = glass.sample(direction(c), uLobe, uniform2(rng), TransportMode::Importance);
            if (!(s.pdf > 0)) continue;
            EXPECT_LE(s.f.x * absCosTheta(s.wi) / s.pdf, 1.001f) << c;
        }
}

TEST(MicrofacetDielectric, BlackReflectsNothing) {
    const MicrofacetDielectric black(Rgb(0.f), Rgb(0.f), TrowbridgeReitz(0.4f, 0.4f), 1.5f);
    EXPECT_TRUE(isBlack(furnace(black, direction(0.5f))));
    EXPECT_TRUE(isBlack(black.albedo(direction(0.5f))));
}

}  // namespace
}  // namespace drc
