// Diffuse, glossy, mirror and refractive lobes, with opacity (pbrt's "uber"; PBR 3e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct UberParams {
    RgbTexturePtr kd;            // 0.25
    RgbTexturePtr ks;            // 0.25; glossy
    RgbTexturePtr kr;            // 0; mirror
    RgbTexturePtr kt;            // 0; refraction
    RgbTexturePtr opacity;       // 1; the remaining light passes straight through
    FloatTexturePtr roughness;   // 0.1
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // uRoughness
    FloatTexturePtr eta;         // 1.5
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    Relief relief;               // none
};
MaterialPtr makeUber(UberParams params);

}  // namespace drc
