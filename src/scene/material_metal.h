// A rough conductor (pbrt's "metal"; PBR 3e, section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

// Copper's index of refraction: measured spectra, integrated to RGB.
inline const Rgb kCopperEta(0.2004377f, 0.9240334f, 1.1022120f);
inline const Rgb kCopperK(3.9129485f, 2.4528477f, 2.1421880f);

// Null textures take the values given here, which are pbrt's.
struct MetalParams {
    RgbTexturePtr eta;           // copper
    RgbTexturePtr k;             // copper
    FloatTexturePtr roughness;   // 0.01
    FloatTexturePtr uRoughness;  // roughness
    FloatTexturePtr vRoughness;  // roughness
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeMetal(MetalParams params);

}  // namespace drc
