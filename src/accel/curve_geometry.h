// Curves as Embree's own geometry.
#pragma once
#include <embree3/rtcore.h>

#include "scene/curves.h"

namespace drc {

// One geometry for all of them, whose primitives are the pieces of the curves and whose u is that of a piece. Reads the
// control points where they are. To be committed by the caller.
RTCGeometry makeCurveGeometry(RTCDevice device, const Curves& curves);

}  // namespace drc
