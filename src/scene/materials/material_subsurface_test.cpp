#include "scene/materials/material_subsurface.h"

#include "scene/lobes/half_space_albedo.h"
#include "scene/lobes/half_space_testing.h"
#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(Subsurface, Bsdf) {
    checkMaterial(makeSubsurface({}));
    SubsurfaceParams p;
    p.sigmaA = colour(0.1f, 0.5f, 3);
    p.sigmaS = colour(1, 1, 1);
    p.g = 0.7f;
    p.eta = 1.5f;
    p.kr = colour(0.8f, 0.8f, 0.8f);
    p.kt = colour(0.5f, 0.7f, 1);
    checkMaterial(makeSubsurface(p));
    p.uRoughness = number(0.3f);
    p.vRoughness = number(0.2f);
    for (const auto scale : {SubsurfaceParams::Roughness::Alpha, SubsurfaceParams::Roughness::Squared,
                             SubsurfaceParams::Roughness::Mapped}) {
        p.scale = scale;
        checkMaterial(makeSubsurface(p));
    }
    p.reflectance = colour(0.9f, 0.4f, 0.2f);
    checkMaterial(makeSubsurface(p));
    EXPECT_EQ(bsdfOf(makeSubsurface(p)).size(), 2);
    p.eta = 1;
    EXPECT_EQ(bsdfOf(makeSubsurface(p)).size(), 1);
}

// What leaves, wherever, of light from one direction: within .025 of a random walk from there. (Of light from
// everywhere, two per cent: half_space_albedo_test.cpp.) Of light from steep directions less comes back.
TEST(Subsurface, AlbedoIsThatOfRandomWalks) {
    for (const float g : {0.f, 0.8f})
        for (const float cosine : {1.f, 0.6f, 0.2f}) {
            SubsurfaceParams p;
            p.g = g;
            const float entered = 1 - fresnelDielectric(cosine, 1, p.eta);
            const auto walked = walkedShares(g, p.eta, cosine, 40000);
            for (size_t k = 0; k < kWalkedAlbedos.size(); ++k) {
                p.sigmaS = colour(kWalkedAlbedos[k], kWalkedAlbedos[k], kWalkedAlbedos[k]);
                p.sigmaA = colour(1 - kWalkedAlbedos[k], 1 - kWalkedAlbedos[k], 1 - kWalkedAlbedos[k]);
                const Bsdf bsdf = bsdfOf(makeSubsurface(p));
                const float found =
                    meanWeight(bsdf, bsdf.frame().toWorld(direction(cosine)), LobeFlags::All, 4000).value.y;
                EXPECT_NEAR(found, 1 - entered + entered * walked[k].mean, 0.025f)
                    << "g " << g << ", cos " << cosine << ", albedo " << kWalkedAlbedos[k];
            }
        }
}

// A surface that absorbs nothing is white, but for what microfacets lose.
TEST(Subsurface, Furnace) {
    SubsurfaceParams p;
    p.sigmaA = colour(0, 0, 0);
    for (const float c : {0.9f, 0.4f, -0.7f}) {
        const Bsdf bsdf = bsdfOf(makeSubsurface(p));
        EXPECT_NEAR(meanWeight(bsdf, bsdf.frame().toWorld(direction(c))).value.x, 1, 1e-3f);
    }
    // A medium that neither absorbs nor scatters lets the light go on for ever.
    p.sigmaS = colour(0, 0, 0);
    EXPECT_EQ(bsdfOf(makeSubsurface(p)).size(), 1);
}

TEST(Subsurface, ReflectanceIsTheShareOfWhatEnters) {
    SubsurfaceParams p;
    p.reflectance = colour(0.6f, 0.3f, 0);
    const Bsdf bsdf = bsdfOf(makeSubsurface(p));
    const float fresnel = fresnelDielectric(0.7f, 1, p.eta);
    const Rgb found = meanWeight(bsdf, bsdf.frame().toWorld(direction(0.7f))).value;
    const Rgb expected = Rgb(fresnel) + Rgb(0.6f, 0.3f, 0) * (1 - fresnel);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 2e-3f);
}

TEST(Subsurface, Constancy) {
    using P = SubsurfaceParams;
    checkConstancy(makeSubsurface, P{}, &P::sigmaA, &P::sigmaS, &P::reflectance, &P::kr, &P::kt, &P::roughness,
                   &P::uRoughness, &P::vRoughness);
}

TEST(Subsurface, MaterialsShareTheAlbedosOfAMedium) {
    const auto one = halfSpaceAlbedo(0.3f, 1.4f);
    EXPECT_EQ(one, halfSpaceAlbedo(0.3f, 1.4f));
    EXPECT_NE(one, halfSpaceAlbedo(0.3f, 1.41f));
}

}  // namespace
}  // namespace drc
