// Ideal diffuse reflection and transmission (pbrt-v4's "diffusetransmission"; PBR 4e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt-v4.
struct DiffuseTransmissionParams {
    RgbTexturePtr reflectance;    // 0.25
    RgbTexturePtr transmittance;  // 0.25
    float scale = 1;              // multiplies both
    Relief relief;                // none
};
MaterialPtr makeDiffuseTransmission(DiffuseTransmissionParams params);

}  // namespace drc
