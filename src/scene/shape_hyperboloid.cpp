#include "scene/shape_hyperboloid.h"

#include "scene/shape_of_revolution.h"

namespace drc {

ShapePtr makeHyperboloid(const HyperboloidParams& params) {
    const auto profile = RevolutionProfile::line(Vec3d(params.p1), Vec3d(params.p2));
    return makeShapeOfRevolution(params.objectToWorld, params.reverseOrientation, params.phiMax, profile);
}

}  // namespace drc
