// A smooth or rough boundary between dielectrics (pbrt-v4's "dielectric"; PBR 4e, section 9.7), and a thin dielectric
// sheet (pbrt-v4's "thindielectric").
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt-v4.
struct DielectricParams {
    FloatTexturePtr eta;         // 1.5; index on the side opposite to the normal
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is alpha squared, not alpha
    Relief relief;               // none
};
MaterialPtr makeDielectric(DielectricParams params);

struct ThinDielectricParams {
    FloatTexturePtr eta;  // 1.5
    Relief relief;        // none
};
MaterialPtr makeThinDielectric(ThinDielectricParams params);

}  // namespace drc
