// The two shapes that are triangle meshes: inline, and in a PLY file.
#pragma once
#include "pbrt/shape_factory.h"

namespace drc::pbrt {

Geometry triangleMesh(const ShapeContext& context);
Geometry plyMesh(const ShapeContext& context);

}  // namespace drc::pbrt
