// The shapes that become triangle meshes: meshes in the scene file, bilinear patches, PLY files, subdivision surfaces
// and height fields.
#pragma once
#include "pbrt/shape_factory.h"

namespace drc::pbrt {

Geometry triangleMesh(const ShapeContext& context);
Geometry bilinearMesh(const ShapeContext& context);
Geometry plyMesh(const ShapeContext& context);
Geometry loopSubdivision(const ShapeContext& context);
Geometry heightField(const ShapeContext& context);

}  // namespace drc::pbrt
