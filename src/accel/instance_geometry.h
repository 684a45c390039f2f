// Instances of objects, still or moving, as Embree's own geometry.
#pragma once
#include <embree3/rtcore.h>

#include "math/animated_transform.h"

namespace drc {

// To be committed by the caller.
RTCGeometry makeInstanceGeometry(RTCDevice device, RTCScene object, const AnimatedTransform& objectToWorld);

// Where a ray of that time meets a moving instance: objectToWorld.at(time), but for the approximations that Embree
// makes between its time steps. Hits must be placed by the same ones, or rays that leave them would start off the
// surface.
Transform instanceToWorld(RTCGeometry instance, float time);

}  // namespace drc
