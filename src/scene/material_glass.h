// Glass, smooth or rough (pbrt's "glass"; PBR 3e, section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt's.
struct GlassParams {
    RgbTexturePtr kr;            // 1
    RgbTexturePtr kt;            // 1
    FloatTexturePtr eta;         // 1.5; of the side that the normal points away from
    FloatTexturePtr uRoughness;  // 0; smooth if both are
    FloatTexturePtr vRoughness;  // 0
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeGlass(GlassParams params);

}  // namespace drc
