// A diffuse base with a glossy dielectric highlight (pbrt's "plastic"; PBR 3e, section 9.2.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct PlasticParams {
    RgbTexturePtr kd;            // 0.25
    RgbTexturePtr ks;            // 0.25
    FloatTexturePtr roughness;   // 0.1
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    Relief relief;               // none
};
MaterialPtr makePlastic(PlasticParams params);

}  // namespace drc
