// A sphere, disk, ... under a perspective (not affine) transformation, as a fine mesh with exact normals. The
// transformation turns the shape into another kind of surface.
#pragma once
#include "scene/shapes/shape.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc {

// Whether the last row of the matrix is (0, 0, 0, 1), up to rounding.
bool isAffine(const Transform& t);

// Mesh of the shape with its points transformed by toWorld and divided by w. shape: in its own space. Throws Error if
// (u, v) does not determine the shape's points (curves), or if a part of the shape is moved to infinity.
TriangleMesh projectedShape(const Shape& shape, const Transform& toWorld);

}  // namespace drc
