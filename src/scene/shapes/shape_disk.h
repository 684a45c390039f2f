// A disk, ring or sector at z = height of object space (PBR 3e, section 3.4).
#pragma once
#include "scene/shapes/shape.h"

namespace drc {

struct DiskParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float height = 0;
    float radius = 1;
    float innerRadius = 0;
    float phiMax = 360;  // degrees from +x towards +y
};

// u = phi / phiMax, v is 1 at the inner radius and 0 at the outer. ng is +z of object space; ReverseOrientation flips
// it.
ShapePtr makeDisk(const DiskParams& params);

}  // namespace drc
