// Heights over a regular grid, as triangles (pbrt's "heightfield").
#pragma once
#include <span>

#include "scene/triangle_mesh.h"

namespace drc {

// nx times ny heights z, row by row from y = 0, over the unit square; both at least two. uv are x and y, and all
// triangles face +z.
TriangleMesh makeHeightField(uint32_t nx, uint32_t ny, std::span<const float> heights);

}  // namespace drc
