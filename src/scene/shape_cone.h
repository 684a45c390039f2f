// A cone about the z axis of object space, with its base at z = 0 (PBR 3e, section 3.5.1).
#pragma once
#include "scene/shape.h"

namespace drc {

struct ConeParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float radius = 1;    // of the base, which is open
    float height = 1;    // z of the apex
    float phiMax = 360;  // degrees from +x towards +y
};

// u = phi / phiMax, v from the base to the apex. ng points outward in a right-handed, unreversed frame if the height is
// positive; as in pbrt, ReverseOrientation and a transform that swaps handedness each turn it inward.
ShapePtr makeCone(const ConeParams& params);

}  // namespace drc
