// A smooth or rough conductor (pbrt-v4's "conductor"; PBR 4e, section 10.5.5).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt-v4's.
struct ConductorParams {
    RgbTexturePtr eta;           // copper
    RgbTexturePtr k;             // copper
    RgbTexturePtr reflectance;   // none; in place of eta and k, what is reflected at normal incidence
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is alpha squared, not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeConductor(ConductorParams params);

}  // namespace drc
