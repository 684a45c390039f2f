// When the film is exposed, and when the things that move are where. Times are the scene file's and have no unit.
#pragma once
#include "math/vec.h"

namespace drc {

struct Shutter {
    float open = 0, close = 1;
    // What moves starts at the first and stands still again from the second on: pbrt's TransformTimes.
    float motionStart = 0, motionEnd = 1;

    // Ray::time of a ray at the u-th part of the exposure, u in [0, 1]: as a share of the motion, in [0, 1].
    float motion(float u) const {
        const float time = lerp(u, open, close);
        if (time <= motionStart) return 0;
        return time >= motionEnd ? 1 : (time - motionStart) / (motionEnd - motionStart);
    }
};

}  // namespace drc
