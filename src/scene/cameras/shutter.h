// The exposure interval and the motion interval. Times are those of the scene file and have no unit.
#pragma once
#include "math/vec.h"

namespace drc {

struct Shutter {
    float open = 0, close = 1;
    // Objects move from motionStart to motionEnd: pbrt's TransformTimes.
    float motionStart = 0, motionEnd = 1;

    // Converts the fraction u in [0, 1] of the exposure to Ray::time: the fraction of the motion interval, clamped to
    // [0, 1].
    float motion(float u) const {
        const float time = lerp(u, open, close);
        if (time <= motionStart) return 0;
        return time >= motionEnd ? 1 : (time - motionStart) / (motionEnd - motionStart);
    }
};

}  // namespace drc
