// Diffuse reflection, Lambertian or rough (pbrt's "matte" and "diffuse"; PBR 3e, section 9.2.1).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct MatteParams {
    RgbTexturePtr kd;             // 0.5
    FloatTexturePtr sigma;        // 0; Oren-Nayar roughness in degrees, clamped to [0, 90]
    FloatTexturePtr roughness{};  // 0; that of RoughDiffuse, clamped to [0, 1]; where it is not 0, sigma is ignored
    Relief relief;                // none
};
MaterialPtr makeMatte(MatteParams params);

}  // namespace drc
