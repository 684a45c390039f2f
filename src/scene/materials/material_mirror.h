// A perfect mirror (pbrt's "mirror"; PBR 3e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

// The comments give the defaults for null textures, which are those of pbrt.
struct MirrorParams {
    RgbTexturePtr kr;  // 0.9
    Relief relief;     // none
};
MaterialPtr makeMirror(MirrorParams params);

}  // namespace drc
