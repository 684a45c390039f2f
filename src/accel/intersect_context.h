// The data that queries pass through Embree to the intersection functions of shapes and to filters.
#pragma once
#include <embree3/rtcore.h>

#include "scene/shapes/shape.h"

namespace drc {

// Values of RTCRay::id, which encodes Ray::fromCamera and Ray::mirrored.
inline constexpr unsigned kDiffuse = 0, kFromCamera = 1, kMirrored = 2;

// Every call of rtcIntersect1 on an Accel's scene needs one; rtcOccluded1 does not.
struct IntersectContext : RTCIntersectContext {
    explicit IntersectContext(ShapeHit& shape) : latest(shape) { rtcInitIntersectContext(this); }
    // The last accepted hit on a shape. Embree only accepts hits nearer than all before, so if the ray's final hit is
    // on a shape at all, it is this one.
    ShapeHit& latest;
};

}  // namespace drc
