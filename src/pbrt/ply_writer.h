// Writes triangle meshes to PLY files.
#pragma once
#include <string>

#include "scene/shapes/triangle_mesh.h"

namespace drc::pbrt {

// Writes a little-endian binary file, whole or not at all, with single-precision vertices x y z and, if the mesh has
// them, nx ny nz and u v. Tangents and flipNormal are left out. Throws Error with the path if the file cannot be
// written.
void writePly(const TriangleMesh& mesh, const std::string& path);

}  // namespace drc::pbrt
