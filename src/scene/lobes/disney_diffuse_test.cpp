#include "scene/lobes/disney_diffuse.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

DisneyDiffuse only(Rgb DisneyDiffuseColors::*part, float roughness = 0.5f, const Rgb& color = Rgb(1.f)) {
    DisneyDiffuseColors colors;
    colors.*part = color;
    return DisneyDiffuse(colors, roughness);
}
constexpr Rgb DisneyDiffuseColors::*kParts[] = {&DisneyDiffuseColors::base, &DisneyDiffuseColors::flat,
                                                &DisneyDiffuseColors::retro, &DisneyDiffuseColors::sheen};

TEST(DisneyDiffuse, Sampling) {
    const Rgb half(0.5f);
    checkSampling(DisneyDiffuse({.base = half, .flat = half, .retro = half, .sheen = half}, 0.7f));
}

TEST(DisneyDiffuse, EnergyReciprocityAndAlbedoOfEachPart) {
    for (const auto part : kParts)
        for (const float roughness : {0.f, 0.5f, 1.f}) {
            SCOPED_TRACE("roughness " + std::to_string(roughness));
            const DisneyDiffuse lobe = only(part, roughness);
            // Burley's approximate subsurface scattering is the only part that reflects too much by itself.
            checkEnergy(lobe, part == &DisneyDiffuseColors::flat ? 0.6f : 0.f);
            checkReciprocity(lobe);
            checkAlbedo(lobe, 0.1f);
        }
}

TEST(DisneyDiffuse, TheBaseAloneIsSeparable) {
    for (const auto part : kParts) EXPECT_EQ(only(part).isSeparable(), part == &DisneyDiffuseColors::base);
    checkSeparable(only(&DisneyDiffuseColors::base, 0.7f, Rgb(0.8f, 0.5f, 0.3f)));
}

TEST(DisneyDiffuse, HandComputed) {
    // wo = wi at 60 degrees: Schlick weights 1/32, cosine to the half vector 1.
    const Vec3 w = direction(0.5f);
    const float base = 63.f / 64;
    EXPECT_NEAR(only(&DisneyDiffuseColors::base).f(w, w).x, base * base * kInvPi, 1e-6f);
    // Roughness 0.5: strength 1, so that 2/32 is left.
    EXPECT_NEAR(only(&DisneyDiffuseColors::retro).f(w, w).x, 2 / 32.f * kInvPi, 1e-6f);
    // lerp(1/32, 1, 0.5)^2 = (63/64)^2, cosines sum to 1: 1.25 ((63/64)^2 0.5 + 0.5).
    EXPECT_NEAR(only(&DisneyDiffuseColors::flat).f(w, w).x, 1.25f * (0.5f * base * base + 0.5f) * kInvPi, 1e-6f);
    EXPECT_NEAR(only(&DisneyDiffuseColors::sheen).f(w, w).x, 0, 1e-6f);
    // At right angles the half vector is at 45 degrees: (1 - sqrt(1/2))^5.
    const Vec3 a(std::sqrt(0.5f), 0, std::sqrt(0.5f)), b(-a.x, 0, a.z);
    EXPECT_NEAR(only(&DisneyDiffuseColors::sheen).f(a, b).x, 0.0021555f, 1e-6f);
}

TEST(DisneyDiffuse, SmoothBaseIsNearlyLambertian) {
    EXPECT_NEAR(only(&DisneyDiffuseColors::base).albedo(Vec3(0, 0, 1)).x, 41 / 42.f, 1e-6f);
    EXPECT_NEAR(furnace(only(&DisneyDiffuseColors::base), Vec3(0, 0, 1), 100000).x, 41 / 42.f, 1e-3f);
}

}  // namespace
}  // namespace drc
