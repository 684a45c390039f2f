// Detects two triangles that form a parallelogram, as most lamps and windows of a room do. A parallelogram is sampled
// by p = corner + u side0 + v side1, which preserves the stratification of (u, v): there is no fold at the diagonal,
// and no random number is spent on choosing a half.
#pragma once
#include <array>
#include <optional>

#include "math/vec.h"

namespace drc {

// The points corner + u * side0 + v * side1 for u, v in [0, 1].
struct Parallelogram {
    Vec3 corner, side0, side1;
};

// The parallelogram of two triangles with the same winding that share two corners exactly; the fourth corner may be off
// by rounding errors. Empty if they do not form a parallelogram. `corner` is the corner that belongs to the first
// triangle only.
std::optional<Parallelogram> parallelogramOf(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

}  // namespace drc
