#include "scene/shapes/shape_paraboloid.h"

#include "scene/shapes/shape_of_revolution.h"

namespace drc {

ShapePtr makeParaboloid(const ParaboloidParams& params) {
    const double low = std::min(params.zMin, params.zMax), high = std::max(params.zMin, params.zMax);
    const auto profile = RevolutionProfile::parabola(params.radius, low, high);
    return makeShapeOfRevolution(params.objectToWorld, params.reverseOrientation, params.phiMax, profile);
}

}  // namespace drc
