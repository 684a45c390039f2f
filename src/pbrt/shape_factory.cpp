#include "pbrt/shape_factory.h"

#include "pbrt/mesh_shapes.h"
#include "pbrt/registry.h"
#include "scene/shape_disk.h"
#include "scene/shape_sphere.h"

namespace drc::pbrt {
namespace {

Geometry sphere(const ShapeContext& context) {
    const ParamSet& params = context.params;
    SphereParams p;
    p.objectToWorld = context.objectToWorld;
    p.reverseOrientation = context.reverseOrientation;
    p.radius = params.getFloat("radius", 1);
    if (!(p.radius > 0)) fail(params.pos(), "the radius of a sphere must be positive");
    p.zMin = params.getFloat("zmin", -p.radius);
    p.zMax = params.getFloat("zmax", p.radius);
    p.phiMax = params.getFloat("phimax", 360);
    Geometry geometry;
    geometry.shape = makeSphere(p);
    return geometry;
}

Geometry disk(const ShapeContext& context) {
    const ParamSet& params = context.params;
    DiskParams p;
    p.objectToWorld = context.objectToWorld;
    p.reverseOrientation = context.reverseOrientation;
    p.height = params.getFloat("height", 0);
    p.radius = params.getFloat("radius", 1);
    if (!(p.radius > 0)) fail(params.pos(), "the radius of a disk must be positive");
    p.innerRadius = params.getFloat("innerradius", 0);
    p.phiMax = params.getFloat("phimax", 360);
    Geometry geometry;
    geometry.shape = makeDisk(p);
    return geometry;
}

using ShapeMaker = Geometry (*)(const ShapeContext&);
constexpr Registered<ShapeMaker> kShapes[] = {
    {"cone", nullptr},        {"curve", nullptr},       {"cylinder", nullptr},   {"disk", disk},
    {"heightfield", nullptr}, {"hyperboloid", nullptr}, {"loopsubdiv", nullptr}, {"nurbs", nullptr},
    {"paraboloid", nullptr},  {"plymesh", plyMesh},     {"sphere", sphere},      {"trianglemesh", triangleMesh},
};

constexpr Registered<ShapeMaker> kShapesV4[] = {
    {"bilinearmesh", bilinearMesh}, {"curve", nullptr},   {"cylinder", nullptr}, {"disk", disk},
    {"loopsubdiv", nullptr},        {"plymesh", plyMesh}, {"sphere", sphere},    {"trianglemesh", triangleMesh},
};

}  // namespace

std::optional<Geometry> makeShape(const std::string& type, const ShapeContext& context) {
    const auto make = findMaker<ShapeMaker>(kShapes, "shape", type, context.params.pos(), "the shape is left out");
    if (make == nullptr) return std::nullopt;
    return make(context);
}

std::optional<Geometry> makeShapeV4(const std::string& type, const ShapeContext& context) {
    const auto make = findMaker<ShapeMaker>(kShapesV4, "shape", type, context.params.pos(), "the shape is left out");
    if (make == nullptr) return std::nullopt;
    Geometry geometry = make(context);
    geometry.alpha = alphaMaskOf(context, "alpha");
    return geometry;
}

}  // namespace drc::pbrt
