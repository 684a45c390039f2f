// A paraboloid around the z axis of object space, with its apex at the origin (PBR 3e, section 3.5.2).
#pragma once
#include "scene/shapes/shape.h"

namespace drc {

struct ParaboloidParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    float radius = 1;  // at the larger of the two z values below
    float zMin = 0;
    float zMax = 1;
    float phiMax = 360;  // degrees from +x towards +y
};

// u = phi / phiMax, v runs from the smaller z to the larger, which must be positive. ng points outward (downward at the
// apex), also under mirroring; ReverseOrientation flips it.
ShapePtr makeParaboloid(const ParaboloidParams& params);

}  // namespace drc
