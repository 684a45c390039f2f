// A surface that light enters and leaves again after scattering below it (pbrt's "subsurface" and "kdsubsurface"; PBR
// 3e, sections 9.2 and 11.4). It is approximated by a BSDF, so light leaves where it has entered;
// docs/layered-materials.md describes the approximation.
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct SubsurfaceParams {
    // The medium below the surface. Only the ratio sigmaS / sigmaA and g matter.
    RgbTexturePtr sigmaA;  // 0.0011, 0.0024, 0.014 (whole milk); absorption
    RgbTexturePtr sigmaS;  // 2.55, 3.21, 3.77; scattering
    float g = 0;           // mean cosine of its phase function
    // In place of the medium, if not null: the share of the entered light that leaves again.
    RgbTexturePtr reflectance;  // none

    RgbTexturePtr kr;            // 1; scales the reflection off the surface
    RgbTexturePtr kt;            // 1; scales the light that enters
    float eta = 1.33f;           // index of refraction below the surface; less than 1 counts as 1
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    // Meaning of the roughnesses: alpha, its square (pbrt-v4), or a number in [0, 1] that is mapped to alpha (pbrt-v3).
    enum class Roughness { Alpha, Squared, Mapped } scale = Roughness::Alpha;
    Relief relief;  // none
};
MaterialPtr makeSubsurface(SubsurfaceParams params);

}  // namespace drc
