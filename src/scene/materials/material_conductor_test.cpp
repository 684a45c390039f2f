#include "scene/materials/material_conductor.h"

#include "scene/materials/conductor_textures.h"
#include "scene/materials/material_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(Conductor, Bsdf) {
    checkMaterial(makeConductor({}));
    EXPECT_FALSE(bsdfOf(makeConductor({})).hasNonSpecular());
    const Bsdf smooth = bsdfOf(makeConductor({}));
    expectClose(meanWeight(smooth, smooth.frame().n).value, fresnelConductor(1, kCopperEta, kCopperK), 1e-4f);
    ConductorParams p;
    p.uRoughness = number(0.2f);
    p.vRoughness = number(0.02f);
    checkMaterial(makeConductor(p));
    EXPECT_FALSE(bsdfOf(makeConductor(p)).hasSpecular());
}

TEST(Conductor, ReflectanceIsWhatNormalIncidenceReflects) {
    ConductorParams p;
    p.reflectance = colour(0.9f, 0.5f, 0);
    const Bsdf bsdf = bsdfOf(makeConductor(p));
    expectClose(meanWeight(bsdf, bsdf.frame().n).value, Rgb(0.9f, 0.5f, 0), 1e-3f);
    p.reflectance = colour(1, 1, 1);
    EXPECT_NEAR(weightAtNormal(makeConductor(p)), 1, 1e-3f);
}

TEST(Conductor, IsConstantUnlessATextureVaries) {
    checkConstancy<ConductorParams>(makeConductor, {}, &ConductorParams::eta, &ConductorParams::k,
                                    &ConductorParams::reflectance, &ConductorParams::roughness,
                                    &ConductorParams::uRoughness, &ConductorParams::vRoughness);
}

}  // namespace
}  // namespace drc
