// The material "principled", DRC's own in both dialects: see docs/principled.md.
#pragma once
#include "pbrt/material_common.h"

namespace drc::pbrt {

// relief: from the dialect's own parameters.
MaterialPtr principledOf(const TextureParams& params, Relief relief);

}  // namespace drc::pbrt
