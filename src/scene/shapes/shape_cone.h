// A cone around the z axis of object space, with its base at z = 0 (PBR 3e, section 3.5.1).
#pragma once
#include "scene/shapes/shape.h"

namespace drc {

struct ConeParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float radius = 1;    // of the base, which has no cap
    float height = 1;    // z of the apex
    float phiMax = 360;  // degrees from +x towards +y
};

// u = phi / phiMax, v runs from the base to the apex. If the height is positive, ng points outward, also under
// mirroring; ReverseOrientation flips it.
ShapePtr makeCone(const ConeParams& params);

}  // namespace drc
