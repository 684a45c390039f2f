// Creates media for MakeNamedMedium.
#pragma once
#include "pbrt/dialect.h"
#include "pbrt/param_set.h"
#include "scene/media/medium.h"

namespace drc::pbrt {

// Inhomogeneous media become empty space, with a warning. Throws Error for types that do not exist in the dialect.
Medium makeMedium(const ParamSet& params, Dialect dialect);

}  // namespace drc::pbrt
