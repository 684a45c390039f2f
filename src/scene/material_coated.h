// Surfaces under a coat of dielectric (pbrt-v4's "coateddiffuse" and "coatedconductor"; PBR 4e, section 14.3). pbrt
// walks at random between base and coat; these evaluate a closed form (docs/layered-materials.md).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt-v4's.
struct CoatParams {
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    FloatTexturePtr eta;         // 1.5; less than 1 counts as 1
    FloatTexturePtr thickness;   // 0.01; optical depth of what is between coat and base
    RgbTexturePtr albedo;        // 0; of what is between them
    FloatTexturePtr g;           // 0; mean cosine by which it scatters
};

struct CoatedDiffuseParams {
    CoatParams coat;
    RgbTexturePtr reflectance;   // 0.5
    bool remapRoughness = true;  // roughness is alpha squared, not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeCoatedDiffuse(CoatedDiffuseParams params);

struct CoatedConductorParams {
    CoatParams coat;
    RgbTexturePtr eta;           // copper
    RgbTexturePtr k;             // copper
    RgbTexturePtr reflectance;   // none; in place of eta and k, what the bare metal reflects at normal incidence
    FloatTexturePtr roughness;   // 0; of the conductor
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is alpha squared, not alpha; of both
    FloatTexturePtr bump;        // none
};
MaterialPtr makeCoatedConductor(CoatedConductorParams params);

}  // namespace drc
