// A height field on a regular grid, as triangles (pbrt's "heightfield").
#pragma once
#include <span>

#include "scene/shapes/triangle_mesh.h"

namespace drc {

// heights: nx times ny values of z, row by row from y = 0, over the unit square; nx and ny are at least 2. uv equals
// (x, y), and all triangles face +z.
TriangleMesh makeHeightField(uint32_t nx, uint32_t ny, std::span<const float> heights);

}  // namespace drc
