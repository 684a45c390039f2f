// A sphere, disk, ... under a transformation with perspective, which makes another surface of it: as a fine mesh, with
// the exact normals.
#pragma once
#include "scene/shapes/shape.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc {

// Whether the last row of the matrix is 0 0 0 1, but for rounding.
bool isAffine(const Transform& t);

// The shape, in its own space, seen through the transformation, which divides by w. Throws Error if its points are not
// determined by (u, v), as those of curves, or if a part of it comes to lie at infinity.
TriangleMesh projectedShape(const Shape& shape, const Transform& toWorld);

}  // namespace drc
