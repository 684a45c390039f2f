#include "scene/shapes/shape_cone.h"

#include "scene/shapes/shape_of_revolution.h"

namespace drc {

ShapePtr makeCone(const ConeParams& params) {
    const auto profile = RevolutionProfile::line(Vec3d(params.radius, 0, 0), Vec3d(0, 0, params.height));
    return makeShapeOfRevolution(params.objectToWorld, params.reverseOrientation, params.phiMax, profile);
}

}  // namespace drc
