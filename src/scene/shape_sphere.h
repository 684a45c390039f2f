// A sphere about the origin of object space, or a part of it (PBR 3e, section 3.2).
#pragma once
#include "scene/shape.h"

namespace drc {

struct SphereParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float radius = 1;
    float zMin = -kInfinity;  // the part with zMin <= z <= zMax ...
    float zMax = kInfinity;
    float phiMax = 360;  // ... and phi <= phiMax, degrees from +x towards +y
};

// u = phi / phiMax, v from zMin to zMax in equal steps of angle. ng points outward in a right-handed, unreversed frame;
// as in pbrt, ReverseOrientation and a transform that swaps handedness each turn it inward.
ShapePtr makeSphere(const SphereParams& params);

}  // namespace drc
