// Surfaces under a coat of dielectric (pbrt-v4's "coateddiffuse" and "coatedconductor"; PBR 4e, section 14.3). pbrt
// evaluates them by random walks between base and coat; these materials use a closed form (docs/layered-materials.md).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt-v4.
struct CoatParams {
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    FloatTexturePtr eta;         // 1.5; less than 1 counts as 1
    FloatTexturePtr thickness;   // 0.01; optical depth of the medium between interface and base
    RgbTexturePtr albedo;        // 0; single-scattering albedo of that medium
    FloatTexturePtr g;           // 0; mean cosine of its phase function
};

struct CoatedDiffuseParams {
    CoatParams coat;
    RgbTexturePtr reflectance;   // 0.5
    bool remapRoughness = true;  // roughness is alpha squared, not alpha
    Relief relief;               // none
};
MaterialPtr makeCoatedDiffuse(CoatedDiffuseParams params);

struct CoatedConductorParams {
    CoatParams coat;
    RgbTexturePtr eta;           // copper
    RgbTexturePtr k;             // copper
    RgbTexturePtr reflectance;   // none; reflectance of the bare metal at normal incidence, in place of eta and k
    FloatTexturePtr roughness;   // 0; that of the conductor
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // for coat and conductor: roughness is alpha squared, not alpha
    Relief relief;               // none
};
MaterialPtr makeCoatedConductor(CoatedConductorParams params);

}  // namespace drc
