// Creates shapes. A new shape is an entry in the table of shape_factory.cpp.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/limits.h"
#include "pbrt/dialect.h"
#include "pbrt/file_search.h"
#include "pbrt/texture_params.h"
#include "scene/shapes/curves.h"
#include "scene/shapes/shape.h"
#include "scene/shapes/triangle_mesh.h"

namespace drc::pbrt {

struct ShapeContext {
    const ParamSet& params;
    const FileSearch& files;
    Transform objectToWorld;
    bool reverseOrientation = false;
    Dialect dialect = Dialect::V3;
    size_t curvePieces = limits::kCurvePieces;  // maximum number of pieces of a curve
};

// Exactly one of shape and loadMesh is set.
struct Geometry {
    ShapePtr shape{};
    std::shared_ptr<Curves> curves{};  // the same as `shape` if it is curves, so that several can be joined
    // Reads and transforms the mesh. Slow; to be called once, on any thread. Owns everything that it needs.
    std::function<TriangleMeshPtr()> loadMesh{};
    std::string meshFile{};  // that loadMesh() reads, as the scene's file names it; empty: none
    double subdivided = 0;   // number of triangles after subdivision
};

// None, with a warning, for types that are not supported. Throws Error for types that pbrt-v3 does not have either, and
// for wrong parameters. A missing file is reported here, a damaged one when the mesh is loaded. Unknown parameters are
// left for the material.
std::optional<Geometry> makeShape(const std::string& type, const ShapeContext& context);
// The counterpart for pbrt-v4.
std::optional<Geometry> makeShapeV4(const std::string& type, const ShapeContext& context);

// The mask that the parameter "alpha" or "shadowalpha" of a shape gives; null if it is opaque. Throws UndefinedName as
// TextureParams does.
FloatTexturePtr maskOf(const ParamSet& shape, std::string_view name, const NamedTextures& textures);

}  // namespace drc::pbrt
