// An open cylinder, or a part of one, around the z axis of object space (PBR 3e, section 3.3).
#pragma once
#include "scene/shapes/shape.h"

namespace drc {

struct CylinderParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float radius = 1;
    float zMin = -1;
    float zMax = 1;
    float phiMax = 360;  // degrees from +x towards +y
};

// u = phi / phiMax, v runs from the smaller z to the larger. ng points outward, also under mirroring;
// ReverseOrientation flips it.
ShapePtr makeCylinder(const CylinderParams& params);

}  // namespace drc
