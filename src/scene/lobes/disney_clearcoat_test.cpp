#include "scene/lobes/disney_clearcoat.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(DisneyClearcoat, Sampling) {
    checkSampling(DisneyClearcoat(1, 0.1f), {0.97f, 0.4f, -0.6f});
    checkSampling(DisneyClearcoat(0.5f, 0.05f), {0.8f});
}

TEST(DisneyClearcoat, EnergyReciprocityAndAlbedo) {
    for (const float alpha : {0.001f, 0.02f, 0.1f}) {
        checkEnergy(DisneyClearcoat(1, alpha), 0);
        if (alpha > 0.01f) checkReciprocity(DisneyClearcoat(1, alpha));
        checkAlbedo(DisneyClearcoat(1, alpha), 0.02f);
    }
}

TEST(DisneyClearcoat, MicrofacetsCoverTheSurfaceOnce) {
    // At normal incidence the density of wi is that of the normals, d cos / (4 cos), and few miss the upper hemisphere.
    const DisneyClearcoat lobe(1, 0.1f);
    const Vec3 n(0, 0, 1);
    // D = (0.01 - 1) / (pi ln 0.01 * 0.01) = 6.8429; masking (1/2)^2, F = 0.04.
    EXPECT_NEAR(lobe.f(n, n).x, 0.25f * 0.25f * 0.04f * 6.8429f, 1e-5f);
    EXPECT_NEAR(lobe.pdf(n, n), 6.8429f / 4, 1e-3f);
    const double integral = integrateSphere([&](const Vec3& wi) { return lobe.pdf(n, wi); });
    EXPECT_LE(integral, 1);
    EXPECT_GT(integral, 0.8);
}

}  // namespace
}  // namespace drc
