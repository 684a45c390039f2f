// Reads triangle meshes from PLY files: ASCII and binary of either byte order, optionally gzipped.
#pragma once
#include <string>

#include "scene/shapes/triangle_mesh.h"

namespace drc::pbrt {

// Reads positions x y z and, if present, normals nx ny nz and texture coordinates (u v, s t, texture_u texture_v or
// texture_s texture_t). Other properties and elements are skipped. Faces with more than three corners become triangle
// fans; faces with fewer are dropped with a warning. Nothing is transformed. Throws Error "path: ..." if the file is
// missing, malformed or truncated, or if faces have invalid vertex indices.
TriangleMesh readPly(const std::string& path);

}  // namespace drc::pbrt
