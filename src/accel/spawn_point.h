// A point on a surface from which rays start. World space.
#pragma once
#include "math/vec.h"

namespace drc {

struct SpawnPoint {
    Vec3 p{0.f};
    Vec3 ng{0.f};         // geometric normal, unit, on either side
    float footprint = 0;  // width of the ray cone that arrived here
    // Bound on the magnitude of the terms from which p was computed, in world units: where a transform placed the
    // surface, p is only as exact as the sums in that transform (Transform::largestOfSums). 0: the coordinates of p
    // themselves.
    float largest = 0;

    // Origin of a ray in direction d: p, offset to the side of d far enough for the ray not to hit its own surface. The
    // offset is some hundred units in the last place of each coordinate (Waechter and Binder, "A Fast and Robust Method
    // for Avoiding Self-Intersection", Ray Tracing Gems 2019), but at least a few of the largest coordinate or of
    // `largest`.
    Vec3 towards(const Vec3& d) const;
};

}  // namespace drc
