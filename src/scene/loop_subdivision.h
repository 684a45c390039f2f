// Loop's subdivision surfaces (PBR 3e, section 3.8): smooth surfaces over meshes of triangles.
#pragma once
#include <span>

#include "scene/triangle_mesh.h"

namespace drc {

// What so many triangles become.
double subdividedTriangles(size_t triangles, int levels);

// Splits each triangle into four, `levels` times, and moves the vertices to where they would be after infinitely many.
// indices: three a triangle, each below positions.size(). The result has normals, those of the limit surface: as in
// pbrt they look against the winding, to where the triangles appear clockwise.
//
// Throws Error where more than two triangles share an edge, or two are wound against each other, and for more triangles
// than limits::kSubdividedTriangles or than memory has room for, with what tracing rays needs of them. Where separate
// fans of triangles meet in a vertex, each has the vertex for itself; vertices without triangles are left out.
TriangleMesh subdivideLoop(std::span<const Vec3> positions, std::span<const uint32_t> indices, int levels);

}  // namespace drc
