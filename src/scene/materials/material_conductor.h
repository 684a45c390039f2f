// A smooth or rough conductor (pbrt-v4's "conductor"; PBR 4e, section 10.5.5).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt-v4.
struct ConductorParams {
    RgbTexturePtr eta;           // copper
    RgbTexturePtr k;             // copper
    RgbTexturePtr reflectance;   // none; reflectance at normal incidence, in place of eta and k
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is alpha squared, not alpha
    Relief relief;               // none
};
MaterialPtr makeConductor(ConductorParams params);

}  // namespace drc
