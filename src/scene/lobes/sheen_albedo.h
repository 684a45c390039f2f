// The albedo of a layer of fibres on a surface, such as cloth or dust (Zeltner, Burley and Chiang, "Practical
// Multiple-Scattering Sheen Using Linearly Transformed Cosines", SIGGRAPH 2022 talks).
#pragma once
#include "scene/lobes/cosine_curve.h"

namespace drc {

// roughness in [0, 1]: how far the fibres stray from standing upright.
CosineCurve sheenAlbedo(float roughness);

}  // namespace drc
