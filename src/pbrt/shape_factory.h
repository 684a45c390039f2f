// Shapes. A new one is one entry in the table of shape_factory.cpp.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/limits.h"
#include "pbrt/dialect.h"
#include "pbrt/file_search.h"
#include "pbrt/texture_params.h"
#include "scene/curves.h"
#include "scene/shape.h"
#include "scene/triangle_mesh.h"

namespace drc::pbrt {

struct ShapeContext {
    const ParamSet& params;
    const NamedTextures& textures;
    const FileSearch& files;
    Transform objectToWorld;
    bool reverseOrientation = false;
    Dialect dialect = Dialect::V3;
    size_t curvePieces = limits::kCurvePieces;  // that a curve may come to
};

// Exactly one of shape and loadMesh is set.
struct Geometry {
    ShapePtr shape{};
    std::shared_ptr<Curves> curves{};  // if shape is curves, the same: those of several shapes can be made one
    // Reads and transforms the mesh: slow, and to be called once, on any thread. Owns all that it needs.
    std::function<TriangleMeshPtr()> loadMesh{};
    double subdivided = 0;                   // triangles that the mesh becomes by subdivision
    FloatTexturePtr alpha{}, shadowAlpha{};  // of any shape: filled in by makeShape
};

// None, with a warning, for what is not built. Throws Error for a type that pbrt-v3 does not know either and for wrong
// parameters; a missing file is found here, a damaged one when the mesh is loaded. Leaves unknown parameters for the
// material.
std::optional<Geometry> makeShape(const std::string& type, const ShapeContext& context);
// pbrt-v4's, which may all have an alpha mask.
std::optional<Geometry> makeShapeV4(const std::string& type, const ShapeContext& context);

}  // namespace drc::pbrt
