#include "scene/shapes/shape_hyperboloid.h"

#include "scene/shapes/shape_of_revolution.h"

namespace drc {
namespace {

// The pbrt program uses the surface width (x^2 + y^2) - height z^2 = 1, with coefficients such that the surface
// contains the circles of p2 and of a second point beyond p2 on the same line, p2 + (p2 - p1). If these two circles lie
// on a cone around the origin, it tries points further on, and if all points lie on the cone, it never terminates. This
// function tries three points and otherwise returns the cone.
RevolutionProfile profileOf(const Vec3d& p1, const Vec3d& p2) {
    const auto radiusSquared = [](const Vec3d& p) { return p.x * p.x + p.y * p.y; };
    const double r2 = radiusSquared(p2), z2 = p2.z * p2.z;
    for (int i = 1; i <= 3; ++i) {
        const Vec3d beyond = p1 + (p2 - p1) * (2.0 * i);
        const double r = radiusSquared(beyond), z = beyond.z * beyond.z;
        // width r - height z = 1 and width r2 - height z2 = 1.
        const double determinant = r2 * z - r * z2;
        if (!(std::abs(determinant) > 1e-12 * (r2 * z + r * z2))) continue;
        const double width = (z - z2) / determinant, height = (r - r2) / determinant;
        if (width != 0) return RevolutionProfile::hyperbola(p1, p2, width, height);
    }
    return RevolutionProfile::line(p1, p2);
}

}  // namespace

ShapePtr makeHyperboloid(const HyperboloidParams& params) {
    return makeShapeOfRevolution(params.objectToWorld, params.reverseOrientation, params.phiMax,
                                 profileOf(Vec3d(params.p1), Vec3d(params.p2)));
}

}  // namespace drc
