// Loop subdivision surfaces (PBR 3e, section 3.8): smooth surfaces defined by triangle meshes.
#pragma once
#include <span>

#include "scene/shapes/triangle_mesh.h"

namespace drc {

// Number of triangles after subdivision.
double subdividedTriangles(size_t triangles, int levels);

// Splits each triangle into four, `levels` times, and moves the vertices to their limit positions. indices: three per
// triangle, each less than positions.size(). The result has the normals of the limit surface, which as in pbrt point
// against the winding, to the side from which the triangles appear clockwise.
//
// Throws Error if more than two triangles share an edge or two neighbours have opposite winding, and if the result
// would have more triangles than limits::kSubdividedTriangles or than fit into memory together with their acceleration
// structure. A vertex in which separate fans of triangles meet is duplicated for each fan; vertices without triangles
// are dropped.
TriangleMesh subdivideLoop(std::span<const Vec3> positions, std::span<const uint32_t> indices, int levels);

}  // namespace drc
