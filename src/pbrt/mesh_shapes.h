// The shapes that are triangle meshes: inline, of patches, in a PLY file, or made here.
#pragma once
#include "pbrt/shape_factory.h"

namespace drc::pbrt {

Geometry triangleMesh(const ShapeContext& context);
Geometry bilinearMesh(const ShapeContext& context);
Geometry plyMesh(const ShapeContext& context);
Geometry loopSubdivision(const ShapeContext& context);
Geometry heightField(const ShapeContext& context);

}  // namespace drc::pbrt
