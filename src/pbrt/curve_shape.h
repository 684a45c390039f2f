// pbrt's shape "curve": Bezier and B-spline curves of degree two and three.
#pragma once
#include "pbrt/shape_factory.h"

namespace drc::pbrt {

Geometry curve(const ShapeContext& context);

}  // namespace drc::pbrt
