// The mapping's coordinates as a colour, to look at them (pbrt's "uv"; PBR 3e, section 10.5.1).
#pragma once
#include "scene/texture_mapping.h"

namespace drc {

// Red is the fraction of s, green that of t, blue none.
RgbTexturePtr makeUvTexture(const Mapping2D& mapping);

}  // namespace drc
