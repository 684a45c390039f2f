// Creates Embree's own geometry type for instances, static or moving.
#pragma once
#include <embree3/rtcore.h>

#include "math/animated_transform.h"

namespace drc {

// The caller commits the geometry.
RTCGeometry makeInstanceGeometry(RTCDevice device, RTCScene object, const AnimatedTransform& objectToWorld);

// Object-to-world transform of a moving instance at a ray's time, as Embree interpolates it between its time steps. It
// differs slightly from objectToWorld.at(time). Hit points must be computed with Embree's version, or spawned rays
// would start off the surface.
Transform instanceToWorld(RTCGeometry instance, float time);

}  // namespace drc
