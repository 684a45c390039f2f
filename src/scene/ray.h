// A ray in world space, with the width of the cone that it stands for.
#pragma once
#include "math/vec.h"

namespace drc {

struct Ray {
    Vec3 o;
    Vec3 d;                  // unit length, unless said otherwise
    float tMax = kInfinity;  // in units of d
    float time = 0;          // as a share of all motion, in [0, 1]: see Shutter. A path has one time
    // Ray cone (Akenine-Moeller et al., "Texture Level of Detail Strategies for Real-Time Ray Tracing", 2019): width
    // at o in world units, and growth in width per unit of distance. They choose the texture level.
    float coneWidth = 0;
    float coneSpread = 0;
};

}  // namespace drc
