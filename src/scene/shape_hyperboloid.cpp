#include "scene/shape_hyperboloid.h"

#include "scene/shape_of_revolution.h"

namespace drc {
namespace {

// pbrt's program takes the points of width (x^2 + y^2) - height z^2 = 1, with its coefficients chosen so that the
// circles of p2 and of a point on the same line beyond it, p2 + (p2 - p1), lie on the surface. Where those two are on
// one cone around the origin it takes further points, and where all are it never returns: the surface is then that cone
// itself.
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
