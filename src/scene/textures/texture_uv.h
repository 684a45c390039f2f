// The texture coordinates as a colour, for debugging (pbrt's "uv"; PBR 3e, section 10.5.1).
#pragma once
#include "scene/textures/texture_mapping.h"

namespace drc {

// Red is the fractional part of s, green that of t; blue is zero.
RgbTexturePtr makeUvTexture(const Mapping2D& mapping);

}  // namespace drc
