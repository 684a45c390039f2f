// Loop subdivision surfaces (PBR 3e, section 3.8): smooth surfaces defined by triangle meshes.
#pragma once
#include <span>

#include "scene/shapes/triangle_mesh.h"

namespace drc {

// Number of triangles after subdivision.
double subdividedTriangles(size_t triangles, int levels);

// Splits each triangle into four, `levels` times, and moves the vertices to their limit positions. indices: three per
// triangle, each less than positions.size(). The result has the normals of the limit surface. As in pbrt they point to
// the side from which the triangles appear clockwise.
//
// Throws Error if more than two triangles share an edge or two neighbours have opposite winding, or if the result would
// have more than limits::kSubdividedTriangles triangles, or more than fit into memory together with their acceleration
// structure. A vertex shared by several separate fans of triangles is duplicated, one copy per fan; vertices without
// triangles are dropped.
TriangleMesh subdivideLoop(std::span<const Vec3> positions, std::span<const uint32_t> indices, int levels);

}  // namespace drc
