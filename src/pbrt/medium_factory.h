// Creates media for MakeNamedMedium.
#pragma once
#include "pbrt/dialect.h"
#include "pbrt/param_set.h"
#include "scene/media/medium.h"

namespace drc::pbrt {

// Empty space, with a warning, for media that are not the same everywhere. Throws Error for types that the dialect does
// not have either.
Medium makeMedium(const ParamSet& params, Dialect dialect);

}  // namespace drc::pbrt
