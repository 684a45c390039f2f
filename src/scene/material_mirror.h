// A perfect mirror (pbrt's "mirror"; PBR 3e, section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

// Null textures take the values given here, which are pbrt's.
struct MirrorParams {
    RgbTexturePtr kr;      // 0.9
    FloatTexturePtr bump;  // none
};
MaterialPtr makeMirror(MirrorParams params);

}  // namespace drc
