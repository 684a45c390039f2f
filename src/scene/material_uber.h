// A bit of everything: diffuse, glossy, mirror, refraction, and an opacity (pbrt's "uber"; PBR 3e, section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt's.
struct UberParams {
    RgbTexturePtr kd;            // 0.25
    RgbTexturePtr ks;            // 0.25; glossy
    RgbTexturePtr kr;            // 0; mirror
    RgbTexturePtr kt;            // 0; refraction
    RgbTexturePtr opacity;       // 1; the rest passes straight through
    FloatTexturePtr roughness;   // 0.1
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // uRoughness
    FloatTexturePtr eta;         // 1.5
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeUber(UberParams params);

}  // namespace drc
