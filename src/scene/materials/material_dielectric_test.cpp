#include "scene/materials/material_dielectric.h"

#include "scene/materials/material_diffuse_transmission.h"
#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(Dielectric, SmoothAndRough) {
    checkMaterial(makeDielectric({}));
    EXPECT_FALSE(bsdfOf(makeDielectric({})).hasNonSpecular());
    EXPECT_NEAR(weightAtNormal(makeDielectric({})), 1, 1e-5f);
    DielectricParams p;
    p.roughness = number(0.1f);
    checkMaterial(makeDielectric(p));
    EXPECT_FALSE(bsdfOf(makeDielectric(p)).hasSpecular());
    EXPECT_TRUE(bsdfOf(makeDielectric(p)).has(LobeFlags::Transmission, broadLobes(0.2f)));
    p.eta = number(1);
    EXPECT_NEAR(weightAtNormal(makeDielectric(p), kSpecular), 1, 1e-5f);
    checkConstancy<DielectricParams>(makeDielectric, {}, &DielectricParams::eta, &DielectricParams::roughness,
                                     &DielectricParams::uRoughness, &DielectricParams::vRoughness);
}

TEST(ThinDielectricMaterial, Bsdf) {
    checkMaterial(makeThinDielectric({}));
    EXPECT_NEAR(weightAtNormal(makeThinDielectric({})), 1, 1e-5f);
    checkConstancy<ThinDielectricParams>(makeThinDielectric, {}, &ThinDielectricParams::eta);
}

TEST(DiffuseTransmission, Bsdf) {
    checkMaterial(makeDiffuseTransmission({}));
    DiffuseTransmissionParams p;
    p.reflectance = colour(0.2f, 0.3f, 0.4f);
    p.transmittance = colour(0.6f, 0.5f, 0.4f);
    p.scale = 0.5f;
    const Bsdf bsdf = bsdfOf(makeDiffuseTransmission(p));
    constexpr LobeFlags kThrough = LobeFlags::Diffuse | LobeFlags::Transmission;
    constexpr LobeFlags kBack = LobeFlags::Diffuse | LobeFlags::Reflection;
    expectClose(meanWeight(bsdf, bsdf.frame().n, kBack).value, Rgb(0.1f, 0.15f, 0.2f), 1e-4f);
    expectClose(meanWeight(bsdf, bsdf.frame().n, kThrough).value, Rgb(0.3f, 0.25f, 0.2f), 1e-4f);
    checkConstancy<DiffuseTransmissionParams>(makeDiffuseTransmission, {}, &DiffuseTransmissionParams::reflectance,
                                              &DiffuseTransmissionParams::transmittance);
}

}  // namespace
}  // namespace drc
