// Layers of colour that noise disturbs (pbrt's "marble"; PBR 3e, section 10.6.6).
#pragma once
#include "scene/noise.h"
#include "scene/texture_mapping.h"

namespace drc {

struct MarbleParams {
    NoiseSum noise;
    float scale = 1;         // of the whole texture: twice as high, half as large
    float variation = 0.2f;  // how far noise moves the layers, which are perpendicular to y
};
RgbTexturePtr makeMarbleTexture(const MarbleParams& params, const Mapping3D& mapping);

}  // namespace drc
