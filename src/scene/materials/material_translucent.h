// Diffuse and glossy reflection and transmission, for lampshades and leaves (pbrt's "translucent"; PBR 3e,
// section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct TranslucentParams {
    RgbTexturePtr kd;            // 0.25
    RgbTexturePtr ks;            // 0.25
    RgbTexturePtr reflect;       // 0.5; share of kd and ks that is reflected
    RgbTexturePtr transmit;      // 0.5; share that is transmitted
    FloatTexturePtr roughness;   // 0.1
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    Relief relief;               // none
};
MaterialPtr makeTranslucent(TranslucentParams params);

}  // namespace drc
