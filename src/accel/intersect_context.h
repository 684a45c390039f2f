// What queries of nearest hits hand to Embree, and Embree to the functions that intersect shapes.
#pragma once
#include <embree3/rtcore.h>

#include "scene/shape.h"

namespace drc {

// Every call of rtcIntersect1 on the scene of an Accel needs one of these; rtcOccluded1 does not.
struct IntersectContext : RTCIntersectContext {
    explicit IntersectContext(ShapeHit& shape) : latest(shape) { rtcInitIntersectContext(this); }
    // Of the shape that was accepted last. Embree accepts nothing that is not nearer than all before it: if the ray's
    // hit is a shape's at all, this is it.
    ShapeHit& latest;
};

}  // namespace drc
