#include "scene/shapes/shape_cylinder.h"

#include "scene/shapes/shape_of_revolution.h"

namespace drc {

ShapePtr makeCylinder(const CylinderParams& params) {
    const double low = std::min(params.zMin, params.zMax), high = std::max(params.zMin, params.zMax);
    const auto profile = RevolutionProfile::line(Vec3d(params.radius, 0, low), Vec3d(params.radius, 0, high));
    return makeShapeOfRevolution(params.objectToWorld, params.reverseOrientation, params.phiMax, profile);
}

}  // namespace drc
