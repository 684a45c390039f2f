// Creates Embree's own geometry type for curves.
#pragma once
#include <embree3/rtcore.h>

#include "scene/shapes/curves.h"

namespace drc {

// One geometry for all curves. Its primitives are the pieces of the curves, and u is the parameter within a piece.
// Shares the control points with `curves`, which must outlive it. The caller commits it.
RTCGeometry makeCurveGeometry(RTCDevice device, const Curves& curves);

}  // namespace drc
