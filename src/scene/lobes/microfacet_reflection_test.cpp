#include "scene/lobes/microfacet_reflection.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

const Fresnel kCopper = Fresnel::conductor(Rgb(0.2f, 0.924f, 1.102f), Rgb(3.912f, 2.452f, 2.142f));

TEST(MicrofacetReflection, Sampling) {
    checkSampling(MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(0.1f, 0.1f), kCopper));
    checkSampling(MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(0.6f, 0.15f), Fresnel::dielectric(1, 1.5f)));
    checkSampling(MicrofacetReflection(Rgb(0.4f), TrowbridgeReitz(1, 1), Fresnel::none()));
}

TEST(MicrofacetReflection, EnergyAndReciprocity) {
    for (const float alpha : {0.001f, 0.05f, 0.3f, 1.f}) {
        const TrowbridgeReitz distribution(alpha, 0.5f * alpha);
        checkEnergy(MicrofacetReflection(Rgb(1.f), distribution, Fresnel::none()));
        if (alpha < 0.01f) continue;  // rounding of the half vector is all that is left
        checkReciprocity(MicrofacetReflection(Rgb(1.f), distribution, kCopper));
        checkReciprocity(MicrofacetReflection(Rgb(1.f), distribution, Fresnel::dielectric(1, 1.5f)));
    }
}

TEST(MicrofacetReflection, SmoothLimitKeepsAllEnergy) {
    const MicrofacetReflection lobe(Rgb(1.f), TrowbridgeReitz(0.01f, 0.01f), Fresnel::none());
    EXPECT_NEAR(furnace(lobe, direction(0.8f)).x, 1, 1e-3f);
}

TEST(MicrofacetReflection, AlbedoEstimate) {
    checkAlbedo(MicrofacetReflection(Rgb(1.f), TrowbridgeReitz(0.2f, 0.2f), kCopper), 0.15f);
}

TEST(MicrofacetReflection, HandComputed) {
    // At normal incidence: D = 1 / (pi alpha^2), G = 1, F = 0.04.
    const MicrofacetReflection lobe(Rgb(0.5f), TrowbridgeReitz(0.4f, 0.4f), Fresnel::dielectric(1, 1.5f));
    const Vec3 n(0, 0, 1);
    EXPECT_NEAR(lobe.f(n, n).x, 0.5f * 0.04f / (4 * kPi * 0.16f), 1e-6f);
    EXPECT_NEAR(lobe.pdf(n, n), 1 / (4 * kPi * 0.16f), 1e-5f);
}

}  // namespace
}  // namespace drc
