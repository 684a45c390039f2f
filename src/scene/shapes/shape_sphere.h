// A sphere around the origin of object space, or a part of one (PBR 3e, section 3.2).
#pragma once
#include "scene/shapes/shape.h"

namespace drc {

struct SphereParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float radius = 1;
    float zMin = -kInfinity;  // the sphere is clipped to zMin <= z <= zMax
    float zMax = kInfinity;
    float phiMax = 360;  // and to phi <= phiMax, in degrees from +x towards +y
};

// u = phi / phiMax, v runs from zMin to zMax in equal steps of the polar angle. ng points outward, also under
// mirroring; ReverseOrientation flips it.
ShapePtr makeSphere(const SphereParams& params);

}  // namespace drc
