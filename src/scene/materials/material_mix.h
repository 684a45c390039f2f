// Two materials, blended (pbrt's "mix"; PBR 3e, section 9.2).
#pragma once
#include "scene/materials/material.h"

namespace drc {

struct MixParams {
    MaterialPtr first, second;  // not null; the mix has the relief of the first
    RgbTexturePtr amount;       // weight of the first (null: 0.5); the second has 1 - amount, clamped to zero
};
MaterialPtr makeMix(MixParams params);

}  // namespace drc
