// Two triangles that together are a parallelogram, which is what most lamps and windows of a room come as. Sampled as
// one, a point follows from two random numbers by a product and a sum, and well-distributed numbers stay so: nothing is
// folded at the diagonal, and none of a number goes to the choice between the halves.
#pragma once
#include <array>
#include <optional>

#include "math/vec.h"

namespace drc {

// All points corner + u * side0 + v * side1 for u, v in [0, 1].
struct Parallelogram {
    Vec3 corner, side0, side1;
};

// Of triangles that are wound alike and have two corners in common, exactly; the fourth corner may be off by what
// rounding does to coordinates. None if they make anything else. corner is the first triangle's own.
std::optional<Parallelogram> parallelogramOf(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

}  // namespace drc
