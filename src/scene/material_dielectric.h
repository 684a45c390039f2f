// A smooth or rough boundary between dielectrics (pbrt-v4's "dielectric"; PBR 4e, section 9.7), and a thin sheet of one
// (pbrt-v4's "thindielectric").
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt-v4's.
struct DielectricParams {
    FloatTexturePtr eta;         // 1.5; of the side that the normal points away from
    FloatTexturePtr roughness;   // 0
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is alpha squared, not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeDielectric(DielectricParams params);

struct ThinDielectricParams {
    FloatTexturePtr eta;   // 1.5
    FloatTexturePtr bump;  // none
};
MaterialPtr makeThinDielectric(ThinDielectricParams params);

}  // namespace drc
