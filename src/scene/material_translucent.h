// Diffuse and glossy reflection and transmission, for lampshades and leaves (pbrt's "translucent"; PBR 3e,
// section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt's.
struct TranslucentParams {
    RgbTexturePtr kd;            // 0.25
    RgbTexturePtr ks;            // 0.25
    RgbTexturePtr reflect;       // 0.5; part of kd and ks that is reflected
    RgbTexturePtr transmit;      // 0.5; part that is transmitted
    FloatTexturePtr roughness;   // 0.1
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    FloatTexturePtr bump;        // none
};
MaterialPtr makeTranslucent(TranslucentParams params);

}  // namespace drc
