// A rough conductor (pbrt's "metal"; PBR 3e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct MetalParams {
    RgbTexturePtr eta;           // copper
    RgbTexturePtr k;             // copper
    FloatTexturePtr roughness;   // 0.01
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    Relief relief;               // none
};
MaterialPtr makeMetal(MetalParams params);

}  // namespace drc
