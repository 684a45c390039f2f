// pbrt's surface for a line segment rotated about the z axis of object space (PBR 3e, section 3.5.3). pbrt's equation
// has no linear term in z, so the surface is the hyperboloid that the segment sweeps only if the waist is at z = 0. The
// surface contains the circle of p2, but not necessarily that of p1. Shading normals, u and v are those of the segment.
#pragma once
#include "scene/shapes/shape.h"

namespace drc {

struct HyperboloidParams {
    Transform objectToWorld{};  // affine
    bool reverseOrientation = false;
    Vec3 p1{0, 0, 0};
    Vec3 p2{1, 1, 1};    // z must differ from p1.z and from 0
    float phiMax = 360;  // degrees from +x towards +y
};

// Returns null if the surface has no point between p1 and p2. u = phi / phiMax, with phi measured from the segment; v
// runs from p1 to p2. If p2 is above p1, ng points outward, also under mirroring; ReverseOrientation flips it.
ShapePtr makeHyperboloid(const HyperboloidParams& params);

}  // namespace drc
