#include "pbrt/shape_factory.h"

#include <algorithm>

#include "pbrt/curve_shape.h"
#include "pbrt/mesh_shapes.h"
#include "pbrt/registry.h"
#include "scene/shapes/projected_shape.h"
#include "scene/shapes/shape_cone.h"
#include "scene/shapes/shape_cylinder.h"
#include "scene/shapes/shape_disk.h"
#include "scene/shapes/shape_hyperboloid.h"
#include "scene/shapes/shape_paraboloid.h"
#include "scene/shapes/shape_sphere.h"

namespace drc::pbrt {
namespace {

// Sets the parameters that all shapes share. Params: the parameter struct of a shape.
template <typename Params>
Params placedParams(const ShapeContext& context) {
    Params p;
    p.objectToWorld = context.objectToWorld;
    p.reverseOrientation = context.reverseOrientation;
    p.phiMax = context.params.getPositiveFloat("phimax", 360);
    return p;
}

Geometry sphere(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto p = placedParams<SphereParams>(context);
    p.radius = params.getPositiveFloat("radius", 1);
    p.zMin = params.getFloat("zmin", -p.radius);
    p.zMax = params.getFloat("zmax", p.radius);
    if (std::clamp(p.zMin, -p.radius, p.radius) == std::clamp(p.zMax, -p.radius, p.radius))
        fail(params.pos(), "nothing of the sphere is between 'zmin' and 'zmax'");
    return {.shape = makeSphere(p)};
}

Geometry disk(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto p = placedParams<DiskParams>(context);
    p.height = params.getFloat("height", 0);
    p.radius = params.getPositiveFloat("radius", 1);
    p.innerRadius = params.getFloat("innerradius", 0);
    if (!(p.innerRadius >= 0 && p.innerRadius < p.radius))
        fail(params.pos(), "the 'innerradius' of a disk must be from 0 to less than its 'radius'");
    return {.shape = makeDisk(p)};
}

Geometry cylinder(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto p = placedParams<CylinderParams>(context);
    p.radius = params.getPositiveFloat("radius", 1);
    p.zMin = params.getFloat("zmin", -1);
    p.zMax = params.getFloat("zmax", 1);
    if (p.zMin == p.zMax) fail(params.pos(), "a cylinder has no height where 'zmin' equals 'zmax'");
    return {.shape = makeCylinder(p)};
}

Geometry cone(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto p = placedParams<ConeParams>(context);
    p.radius = params.getPositiveFloat("radius", 1);
    p.height = params.getFloat("height", 1);
    if (p.height == 0) fail(params.pos(), "the height of a cone must not be zero: use a disk for a flat one");
    return {.shape = makeCone(p)};
}

Geometry paraboloid(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto p = placedParams<ParaboloidParams>(context);
    p.radius = params.getPositiveFloat("radius", 1);
    p.zMin = params.getFloat("zmin", 0);
    p.zMax = params.getFloat("zmax", 1);
    if (!(std::max(p.zMin, p.zMax) > 0) || p.zMin == p.zMax)
        fail(params.pos(), "the larger of 'zmin' and 'zmax' of a paraboloid must be positive, and they must differ");
    return {.shape = makeParaboloid(p)};
}

Geometry hyperboloid(const ShapeContext& context) {
    const ParamSet& params = context.params;
    auto p = placedParams<HyperboloidParams>(context);
    p.p1 = params.getPoint("p1", Vec3(0, 0, 0));
    p.p2 = params.getPoint("p2", Vec3(1, 1, 1));
    if (p.p1.z == p.p2.z)
        fail(params.pos(), "'p1' and 'p2' of a hyperboloid must differ in z: use a disk for a flat ring");
    if (p.p1.x == 0 && p.p1.y == 0 && p.p2.x == 0 && p.p2.y == 0)
        fail(params.pos(), "'p1' and 'p2' of a hyperboloid must not both lie on the z axis");
    if (p.p2.z == 0) std::swap(p.p1, p.p2);  // as in pbrt, which reverses v and the normals
    ShapePtr shape = makeHyperboloid(p);
    if (!shape)
        warn(params.pos(),
             "the equation that pbrt makes of 'p1' and 'p2' has no points between them; nothing is drawn");
    return {.shape = std::move(shape)};
}

using ShapeMaker = Geometry (*)(const ShapeContext&);
constexpr Registered<ShapeMaker> kShapes[] = {
    {"cone", cone},
    {"curve", curve},
    {"cylinder", cylinder},
    {"disk", disk},
    {"heightfield", heightField},
    {"hyperboloid", hyperboloid},
    {"loopsubdiv", loopSubdivision},
    {"nurbs", nullptr},
    {"paraboloid", paraboloid},
    {"plymesh", plyMesh},
    {"sphere", sphere},
    {"trianglemesh", triangleMesh},
};

constexpr Registered<ShapeMaker> kShapesV4[] = {
    {"bilinearmesh", bilinearMesh},  {"curve", curve},     {"cylinder", cylinder}, {"disk", disk},
    {"loopsubdiv", loopSubdivision}, {"plymesh", plyMesh}, {"sphere", sphere},     {"trianglemesh", triangleMesh},
};

// For transforms with perspective: meshes divide by w themselves; other shapes are converted to meshes.
Geometry withPerspective(ShapeMaker maker, const ShapeContext& context) {
    ShapeContext inObject = context;
    inObject.objectToWorld = Transform();
    Geometry geometry = maker(inObject);
    if (!geometry.shape) return maker(context);
    return {.loadMesh = [shape = geometry.shape, toWorld = context.objectToWorld] {
        return std::make_shared<const TriangleMesh>(projectedShape(*shape, toWorld));
    }};
}

std::optional<Geometry> make(std::span<const Registered<ShapeMaker>> table, const std::string& type,
                             const ShapeContext& context) {
    const auto maker = findMaker<ShapeMaker>(table, "shape", type, context.params.pos(), "the shape is left out");
    if (maker == nullptr) return std::nullopt;
    Geometry geometry = isAffine(context.objectToWorld) ? maker(context) : withPerspective(maker, context);
    if (!geometry.shape && !geometry.loadMesh) return std::nullopt;
    return geometry;
}

}  // namespace

std::optional<Geometry> makeShape(const std::string& type, const ShapeContext& context) {
    return make(kShapes, type, context);
}

std::optional<Geometry> makeShapeV4(const std::string& type, const ShapeContext& context) {
    return make(kShapesV4, type, context);
}

FloatTexturePtr maskOf(const ParamSet& shape, std::string_view name, const NamedTextures& textures) {
    FloatTexturePtr mask = TextureParams(shape, textures).scalarOrNull(name);
    // In pbrt-v3, a surface is transparent only where its mask is zero; in pbrt-v4, the mask is the share of rays that
    // hit it.
    const auto isOpaque = [&](float value) { return textures.dialect == Dialect::V4 ? value >= 1 : value != 0; };
    return mask && mask->isConstant() && isOpaque(mask->eval({})) ? nullptr : mask;
}

}  // namespace drc::pbrt
