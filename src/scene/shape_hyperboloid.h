// What pbrt draws for a line segment turned about the z axis of object space (PBR 3e, section 3.5.3): the surface of an
// equation without a term in z, which is the hyperboloid that the segment sweeps only if its narrowest circle is at z =
// 0. The circle of p2 lies on it, that of p1 need not. Normals, u and v are those of the segment.
#pragma once
#include "scene/shape.h"

namespace drc {

struct HyperboloidParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    Vec3 p1{0, 0, 0};
    Vec3 p2{1, 1, 1};    // with another z than p1, and not with z = 0
    float phiMax = 360;  // degrees from +x towards +y
};

// Null if that surface has no point between p1 and p2. u = phi / phiMax, with phi the turn from the segment itself, v
// from p1 to p2. ng points outward in a right-handed, unreversed frame if p2 is above p1; as in pbrt,
// ReverseOrientation and a transform that swaps handedness each turn it inward.
ShapePtr makeHyperboloid(const HyperboloidParams& params);

}  // namespace drc
