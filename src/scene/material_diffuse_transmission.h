// Ideal diffuse reflection and transmission (pbrt-v4's "diffusetransmission"; PBR 4e, section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt-v4's.
struct DiffuseTransmissionParams {
    RgbTexturePtr reflectance;    // 0.25
    RgbTexturePtr transmittance;  // 0.25
    float scale = 1;              // of both
    FloatTexturePtr bump;         // none
};
MaterialPtr makeDiffuseTransmission(DiffuseTransmissionParams params);

}  // namespace drc
