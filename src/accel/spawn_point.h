// A point on a surface from which rays start. World space.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace drc {

// A bound on the rounding errors of a point and of the origin of a ray that starts at it, after transformation to a
// surface's own space. largest: magnitude of the point's largest coordinate, or of the largest term that a coordinate
// is a sum of. Rotations mix coordinates, so that each one has the error of the largest: up to two units in the last
// place in the point, and two more in the ray.
inline float roundingError(float largest) { return 8 * 0x1p-23f * largest; }
inline float roundingError(const Vec3& p) {
    return roundingError(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}

struct SpawnPoint {
    Vec3 p{0.f};
    Vec3 ng{0.f};         // geometric normal, unit, on either side
    float footprint = 0;  // width of the arriving ray cone at p
    // A bound on the distance along ng from the true surface to p, and to the plane in which an intersection test
    // places the surface for a ray that starts at p.
    float error = 0;

    // Origin of a ray in direction d: p, offset by `error` to the side of d. This is far enough for the ray not to hit
    // its own surface, and as little as possible, so that it does not miss another surface close by.
    Vec3 towards(const Vec3& d) const { return p + ng * (dot(ng, d) < 0 ? -error : error); }
};

}  // namespace drc
