// A point on a surface from which rays start. World space.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace drc {

// A bound on the rounding errors of a point whose coordinates, or the terms that they are sums of, are at most this
// large, and of a ray that starts there once it has been transformed to a surface's own space. Rotations mix
// coordinates, so that each has the error of the largest: up to two units in the last place in the point, and as many
// again in the ray.
inline float roundingError(float largest) { return 8 * 0x1p-23f * largest; }
inline float roundingError(const Vec3& p) {
    return roundingError(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}

struct SpawnPoint {
    Vec3 p{0.f};
    Vec3 ng{0.f};         // geometric normal, unit, on either side
    float footprint = 0;  // width of the ray cone that arrived here
    // A bound on how far p, and the plane in which a ray that starts there would find the surface, may be from the true
    // surface, along ng.
    float error = 0;

    // Origin of a ray in direction d: p, moved to the side of d so far that the ray does not hit its own surface, and
    // no farther, so that it does not miss another surface close by.
    Vec3 towards(const Vec3& d) const { return p + ng * (dot(ng, d) < 0 ? -error : error); }
};

}  // namespace drc
