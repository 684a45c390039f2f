// Two materials, blended (pbrt's "mix"; PBR 3e, section 9.2).
#pragma once
#include "scene/material.h"

namespace drc {

struct MixParams {
    MaterialPtr first, second;  // never null; the bump map of the mix is the first's
    RgbTexturePtr amount;       // of the first; null: 0.5. The rest, clamped to zero, is the second's
};
MaterialPtr makeMix(MixParams params);

}  // namespace drc
