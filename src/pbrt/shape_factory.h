// Creates shapes. To add one, add an entry to the table in shape_factory.cpp.
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
    std::shared_ptr<Curves> curves{};  // the same object as `shape` if that is curves, to which others can be appended
    // Reads and transforms the mesh. Slow; call it once, from any thread. Owns all data that it needs.
    std::function<TriangleMeshPtr()> loadMesh{};
    std::string meshFile{};  // file that loadMesh() reads, as named in the scene file; empty: none
    double subdivided = 0;   // number of triangles after subdivision
};

// None, with a warning, for types that are not supported. Throws Error for types that do not exist in pbrt-v3, and for
// wrong parameters. A missing file is reported here, a damaged one when the mesh is loaded. Unknown parameters are left
// to the material.
std::optional<Geometry> makeShape(const std::string& type, const ShapeContext& context);
// The counterpart for pbrt-v4.
std::optional<Geometry> makeShapeV4(const std::string& type, const ShapeContext& context);

// The mask in a shape's parameter "alpha" or "shadowalpha"; null if it is opaque. Throws UndefinedName like
// TextureParams.
FloatTexturePtr maskOf(const ParamSet& shape, std::string_view name, const NamedTextures& textures);

}  // namespace drc::pbrt
