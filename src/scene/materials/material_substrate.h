// A diffuse base under a glossy coat (pbrt's "substrate"; PBR 3e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct SubstrateParams {
    RgbTexturePtr kd;            // 0.5
    RgbTexturePtr ks;            // 0.5
    FloatTexturePtr uRoughness;  // 0.1
    FloatTexturePtr vRoughness;  // 0.1
    bool remapRoughness = true;  // roughness is in [0, 1], not alpha
    Relief relief;               // none
};
MaterialPtr makeSubstrate(SubstrateParams params);

}  // namespace drc
