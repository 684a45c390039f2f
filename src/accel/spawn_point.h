// A point on a surface, as the rays that leave it need it. World space.
#pragma once
#include "math/vec.h"

namespace drc {

struct SpawnPoint {
    Vec3 p{0.f};
    Vec3 ng{0.f};         // geometric normal, unit, on either side
    float footprint = 0;  // width of the arriving ray's cone
    // Of the coordinates that p was computed from, the largest, brought to the scale of the world: where a transform
    // has placed the surface, p is no more exact than the sums that it came from. 0: p's own.
    float largest = 0;

    // Origin of a ray in direction d: p moved off the surface, to the side of d, far enough for the ray not to meet the
    // surface where it starts. By some hundred units in the last place of each coordinate (Waechter and Binder, "A Fast
    // and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems 2019), and by some of the largest at least.
    Vec3 towards(const Vec3& d) const;
};

}  // namespace drc
