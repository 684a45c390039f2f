// The shapes that are triangle meshes: inline, of patches, and in a PLY file.
#pragma once
#include "pbrt/shape_factory.h"

namespace drc::pbrt {

Geometry triangleMesh(const ShapeContext& context);
Geometry bilinearMesh(const ShapeContext& context);
Geometry plyMesh(const ShapeContext& context);

// The mask that the parameter gives; null: opaque.
FloatTexturePtr alphaMaskOf(const ShapeContext& context, std::string_view name);

}  // namespace drc::pbrt
