// Triangle meshes from PLY files: ASCII and binary of either byte order, compressed by gzip or not.
#pragma once
#include <string>

#include "scene/triangle_mesh.h"

namespace drc::pbrt {

// Positions x y z; normals nx ny nz and texture coordinates (u v, s t, texture_u texture_v or texture_s texture_t) if
// the file has them; other properties and elements are skipped. Faces of more than three corners become fans; those of
// fewer are left out with a warning. Nothing is transformed. Throws Error "path: ..." for a file that is missing,
// malformed or cut short, or whose faces name vertices that are not there.
TriangleMesh readPly(const std::string& path);

}  // namespace drc::pbrt
