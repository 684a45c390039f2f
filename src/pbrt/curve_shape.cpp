#include "pbrt/curve_shape.h"

#include <fmt/core.h>

#include <cmath>

namespace drc::pbrt {
namespace {

using Segment = std::array<Vec3, 4>;

Vec3 mix(const Vec3& a, const Vec3& b, float t) { return a * (1 - t) + b * t; }

// Degree elevation: the cubic control points of a quadratic curve.
Segment elevated(const Vec3& a, const Vec3& b, const Vec3& c) { return {a, mix(a, b, 2 / 3.f), mix(b, c, 1 / 3.f), c}; }

// Bezier control points of the segment that these control points of a uniform B-spline define (by blossoming, PBR 3e,
// section 3.7).
Segment fromQuadraticSpline(const Vec3* p) { return elevated(mix(p[0], p[1], 0.5f), p[1], mix(p[1], p[2], 0.5f)); }
Segment fromCubicSpline(const Vec3* p) {
    const Vec3 b = mix(p[1], p[2], 1 / 3.f), c = mix(p[1], p[2], 2 / 3.f);
    return {mix(mix(p[0], p[1], 2 / 3.f), b, 0.5f), b, c, mix(c, mix(p[2], p[3], 1 / 3.f), 0.5f)};
}

std::vector<Segment> segmentsOf(const ParamSet& params) {
    const Param* points = params.find("P", {ParamType::Point3});
    if (points == nullptr) fail(params.pos(), "shape 'curve' needs the parameter 'P' of type 'point3'");
    const int degree = params.getInt("degree", 3);
    if (degree != 2 && degree != 3)
        fail(params.pos(), "the degree of a curve must be 2 or 3, not " + std::to_string(degree));
    const std::string basis = params.getString("basis", "bezier");
    if (basis != "bezier" && basis != "bspline")
        fail(params.pos(), "the basis of a curve must be 'bezier' or 'bspline', not '" + basis + "'");

    const size_t count = points->count(), n = size_t(degree);
    std::vector<Vec3> p(count);
    for (size_t i = 0; i < count; ++i) p[i] = vec3At(points->numbers, i);
    std::vector<Segment> segments;
    if (basis == "bezier") {
        if (count < n + 1 || (count - 1) % n != 0)
            params.failAt(*points, "must have " + std::to_string(n + 1) + " points for a Bezier curve of degree " +
                                       std::to_string(n) + ", and " + std::to_string(n) +
                                       " more for each further segment, found " + std::to_string(count));
        for (size_t i = 0; i + n < count; i += n)
            segments.push_back(n == 2 ? elevated(p[i], p[i + 1], p[i + 2])
                                      : Segment{p[i], p[i + 1], p[i + 2], p[i + 3]});
    } else {
        if (count < n + 1)
            params.failAt(*points, "must have at least " + std::to_string(n + 1) + " points for a B-spline of degree " +
                                       std::to_string(n) + ", found " + std::to_string(count));
        for (size_t i = 0; i + n < count; ++i)
            segments.push_back(n == 2 ? fromQuadraticSpline(&p[i]) : fromCubicSpline(&p[i]));
    }
    return segments;
}

CurveType typeOf(const ParamSet& params) {
    const std::string name = params.getString("type", "flat");
    if (name == "flat") return CurveType::Flat;
    if (name == "cylinder") return CurveType::Cylinder;
    if (name == "tube") return CurveType::Tube;
    if (name == "ribbon") return CurveType::Ribbon;
    fail(params.pos(), "the type of a curve must be 'flat', 'cylinder', 'tube' or 'ribbon', not '" + name + "'");
}

// Unit normals in world space at the ends of the segments; empty for curves that are not ribbons.
std::vector<Vec3> ribbonNormals(const ShapeContext& context, CurveType type, size_t segments) {
    const ParamSet& params = context.params;
    const Param* normals = params.find("N", {ParamType::Normal3});
    if (type != CurveType::Ribbon) {
        if (normals) warn(normals->pos, "the normals of a curve matter for type 'ribbon' alone; ignored");
        return {};
    }
    if (normals == nullptr) fail(params.pos(), "a curve of type 'ribbon' needs the parameter 'N' of type 'normal3'");
    if (normals->count() != segments + 1)
        params.failAt(*normals, "must have one value more than the curve has segments, " +
                                    std::to_string(segments + 1) + ", found " + std::to_string(normals->count()));
    std::vector<Vec3> result(segments + 1);
    for (size_t i = 0; i < result.size(); ++i) {
        result[i] = normalize(context.objectToWorld.normal(vec3At(normals->numbers, i)));
        if (result[i] == Vec3(0.f)) params.failAt(*normals, "must not have zero as a value");
    }
    return result;
}

// The factor by which the transform scales widths: the cube root of its factor for volumes.
float widthScale(const ShapeContext& context) {
    const Transform& t = context.objectToWorld;
    const Vec3 x = t.vector(Vec3(1, 0, 0)), y = t.vector(Vec3(0, 1, 0)), z = t.vector(Vec3(0, 0, 1));
    // Doubles, because the volume may overflow a float where the lengths do not.
    const float scale = float(std::cbrt(std::abs(Imath::V3d(x).dot(Imath::V3d(y).cross(Imath::V3d(z))))));
    for (const Vec3& axis : {x, y, z})
        if (std::abs(length(axis) - scale) > 0.02f * scale) {
            warn(context.params.pos(),
                 "the transformation stretches this curve; its width is scaled alike in all directions");
            break;
        }
    return scale;
}

}  // namespace

Geometry curve(const ShapeContext& context) {
    const ParamSet& params = context.params;
    std::vector<Segment> segments = segmentsOf(params);
    const CurveType type = typeOf(params);
    const std::vector<Vec3> normals = ribbonNormals(context, type, segments.size());
    const float width = params.getNonNegativeFloat("width", 1);
    const float widths[2] = {params.getNonNegativeFloat("width0", width), params.getNonNegativeFloat("width1", width)};
    params.ignore({"splitdepth"});  // how finely pbrt splits curves for its own BVH

    // Flat curves and cylinders always face the viewer, so a mirroring transform has no sides to swap.
    const bool mirrored = context.objectToWorld.swapsHandedness();
    const bool turned = mirrored && type == CurveType::Ribbon;
    auto curves = std::make_shared<Curves>(type, context.reverseOrientation != turned, mirrored);
    const float scale = widthScale(context);
    for (Segment& segment : segments)
        for (Vec3& p : segment) p = context.objectToWorld.point(p);
    const auto widthAt = [&](size_t k) {
        return scale * lerp(float(k) / float(segments.size()), widths[0], widths[1]);
    };
    const auto endWidths = [&](size_t i) { return std::array<float, 2>{widthAt(i), widthAt(i + 1)}; };
    const auto endNormals = [&](size_t i) {
        return type == CurveType::Ribbon ? std::array<Vec3, 2>{normals[i], normals[i + 1]}
                                         : std::array<Vec3, 2>{Vec3(0.f), Vec3(0.f)};
    };
    // A segment takes a few bytes in the file, but may become up to 64 pieces.
    size_t pieces = 0;
    for (size_t i = 0; i < segments.size(); ++i)
        pieces += size_t(curves->piecesOf(segments[i], endWidths(i), endNormals(i)));
    if (pieces > context.curvePieces)
        fail(params.pos(), fmt::format("this curve is so thin and bent that it is cut into {} pieces, and {} may be "
                                       "added to the scene's; make it wider or less bent",
                                       pieces, context.curvePieces));
    placedAt(params.pos(), [&] { curves->reserve(pieces); });
    for (size_t i = 0; i < segments.size(); ++i) curves->add(segments[i], endWidths(i), endNormals(i));
    if (curves->pieceCount() == 0) {
        warn(params.pos(), "all points of this curve are the same; it is left out");
        return {};
    }
    return {.shape = curves, .curves = curves};
}

}  // namespace drc::pbrt
