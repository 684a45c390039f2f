#include "scene/materials/material_coated.h"

#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

CoatParams coatOf(float roughness, float thickness = 0, float eta = 1.5f) {
    CoatParams coat;
    coat.roughness = number(roughness);
    coat.thickness = number(thickness);
    coat.eta = number(eta);
    return coat;
}

TEST(CoatedDiffuseMaterial, Bsdf) {
    CoatedDiffuseParams p;
    checkMaterial(makeCoatedDiffuse(p));
    p.coat = coatOf(0.1f, 0.2f);
    p.coat.albedo = colour(0.8f, 0.5f, 0.2f);
    p.coat.g = number(0.5f);
    checkMaterial(makeCoatedDiffuse(p));
    // Both sides of the surface are coated.
    for (const float c : {0.9f, 0.3f}) {
        const Bsdf bsdf = bsdfOf(makeCoatedDiffuse({}));
        const Rgb front = meanWeight(bsdf, bsdf.frame().toWorld(direction(c))).value;
        expectClose(front, meanWeight(bsdf, bsdf.frame().toWorld(direction(-c))).value, 0.01f);
    }
}

TEST(CoatedDiffuseMaterial, WhiteLosesNothing) {
    for (const float eta : {1.f, 1.5f, 2.f}) {
        CoatedDiffuseParams p;
        p.reflectance = colour(1, 1, 1);
        p.coat = coatOf(0, 0, eta);
        const Bsdf bsdf = bsdfOf(makeCoatedDiffuse(p));
        for (const float c : {0.95f, 0.4f, 0.1f}) {
            const Mean m = meanWeight(bsdf, bsdf.frame().toWorld(direction(c)));
            EXPECT_NEAR(m.value.x, 1, 4 * m.error + 2e-3f) << eta << " " << c;
        }
        // The same with haze that absorbs nothing, however thick.
        p.coat.thickness = number(2);
        p.coat.albedo = colour(1, 1, 1);
        const Bsdf hazy = bsdfOf(makeCoatedDiffuse(p));
        const Mean m = meanWeight(hazy, hazy.frame().n);
        EXPECT_NEAR(m.value.x, 1, 4 * m.error + 2e-3f) << eta;
    }
    // Single scattering at a rough interface loses some energy, but must never gain any.
    for (const float roughness : {0.01f, 0.1f, 0.5f, 1.f}) {
        CoatedDiffuseParams p;
        p.reflectance = colour(1, 1, 1);
        p.coat = coatOf(roughness);
        checkBsdfEnergy(bsdfOf(makeCoatedDiffuse(p)));
    }
}

TEST(CoatedDiffuseMaterial, HandComputed) {
    // At normal incidence: 0.04 off the coat; 0.5 (1 - 0.04) (1 - 0.0918) / (2.25 (1 - 0.5 * 0.5963)) off the base.
    CoatedDiffuseParams p;
    p.coat = coatOf(0);
    EXPECT_NEAR(weightAtNormal(makeCoatedDiffuse(p), kSpecular), 0.04f, 1e-5f);
    EXPECT_NEAR(weightAtNormal(makeCoatedDiffuse(p), LobeFlags::NonSpecular), 0.2761f, 2e-3f);
}

TEST(CoatedConductorMaterial, Bsdf) {
    checkMaterial(makeCoatedConductor({}));
    EXPECT_FALSE(bsdfOf(makeCoatedConductor({})).hasNonSpecular());
    CoatedConductorParams p;
    p.roughness = number(0.1f);
    checkMaterial(makeCoatedConductor(p));
    p.coat = coatOf(0.05f, 0.1f);
    p.coat.albedo = colour(0.5f, 0.5f, 0.5f);
    checkMaterial(makeCoatedConductor(p));
    EXPECT_EQ(bsdfOf(makeCoatedConductor(p)).size(), 3);
}

TEST(CoatedConductorMaterial, ABrightMetalGainsNothing) {
    for (const float base : {0.f, 0.01f, 0.2f, 1.f})
        for (const float face : {0.f, 0.1f, 1.f}) {
            CoatedConductorParams p;
            p.reflectance = colour(1, 1, 1);
            p.roughness = number(base);
            p.coat = coatOf(face, 0.1f);
            p.coat.albedo = colour(1, 1, 1);
            const Bsdf bsdf = bsdfOf(makeCoatedConductor(p));
            for (const float c : {0.9f, 0.5f, 0.1f, -0.6f}) {
                const Mean m = meanWeight(bsdf, bsdf.frame().toWorld(direction(c)), LobeFlags::All, 5000);
                EXPECT_LE(m.value.x, 1.01f + 4 * m.error) << base << " " << face << " " << c;
            }
        }
}

TEST(CoatedMaterials, AreConstantUnlessATextureVaries) {
    const auto withCoat = [](auto params, auto CoatParams::*member) {
        if constexpr (requires { params.coat.*member = std::make_shared<VaryingColour>(); })
            params.coat.*member = std::make_shared<VaryingColour>();
        else
            params.coat.*member = std::make_shared<VaryingNumber>();
        return params;
    };
    const auto check = [&](auto member) {
        EXPECT_FALSE(makeCoatedDiffuse(withCoat(CoatedDiffuseParams{}, member))->isConstant());
        EXPECT_FALSE(makeCoatedConductor(withCoat(CoatedConductorParams{}, member))->isConstant());
    };
    check(&CoatParams::roughness);
    check(&CoatParams::uRoughness);
    check(&CoatParams::vRoughness);
    check(&CoatParams::eta);
    check(&CoatParams::thickness);
    check(&CoatParams::albedo);
    check(&CoatParams::g);
    checkConstancy<CoatedDiffuseParams>(makeCoatedDiffuse, {}, &CoatedDiffuseParams::reflectance);
    checkConstancy<CoatedConductorParams>(makeCoatedConductor, {}, &CoatedConductorParams::eta,
                                          &CoatedConductorParams::k, &CoatedConductorParams::reflectance,
                                          &CoatedConductorParams::roughness, &CoatedConductorParams::uRoughness,
                                          &CoatedConductorParams::vRoughness);
}

}  // namespace
}  // namespace drc
