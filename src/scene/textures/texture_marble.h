// Coloured layers distorted by noise (pbrt's "marble"; PBR 3e, section 10.6.6).
#pragma once
#include "scene/textures/noise.h"
#include "scene/textures/texture_mapping.h"

namespace drc {

struct MarbleParams {
    NoiseSum noise;
    float scale = 1;         // frequency of the whole texture: doubling it halves all sizes
    float variation = 0.2f;  // amplitude of the distortion of the layers, which are perpendicular to y
};
RgbTexturePtr makeMarbleTexture(const MarbleParams& params, const Mapping3D& mapping);

}  // namespace drc
