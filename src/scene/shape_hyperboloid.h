// A line segment turned about the z axis of object space: a hyperboloid of one sheet, or where the line and the axis
// lie in a plane a cone or a cylinder (PBR 3e, section 3.5.3).
#pragma once
#include "scene/shape.h"

namespace drc {

struct HyperboloidParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    Vec3 p1{0, 0, 0};
    Vec3 p2{1, 1, 1};    // with another z than p1
    float phiMax = 360;  // degrees from +x towards +y
};

// u = phi / phiMax, with phi the turn from the segment itself, v from p1 to p2. ng points outward in a right-handed,
// unreversed frame if p2 is above p1; as in pbrt, ReverseOrientation and a transform that swaps handedness each turn it
// inward.
ShapePtr makeHyperboloid(const HyperboloidParams& params);

}  // namespace drc
