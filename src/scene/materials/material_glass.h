// Glass, smooth or rough (pbrt's "glass"; PBR 3e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct GlassParams {
    RgbTexturePtr kr;            // 1
    RgbTexturePtr kt;            // 1
    FloatTexturePtr eta;         // 1.5; index on the side opposite to the normal
    FloatTexturePtr uRoughness;  // 0; smooth if both roughnesses are 0
    FloatTexturePtr vRoughness;  // 0
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    Relief relief;               // none
};
MaterialPtr makeGlass(GlassParams params);

}  // namespace drc
