// Rejects scenes that pbrt's format allows but no machine could render: see limits.h.
#pragma once
#include <memory>

#include "math/animated_transform.h"
#include "pbrt/param_set.h"
#include "pbrt/texture_params.h"
#include "scene/shapes/shape.h"

namespace drc::pbrt {

// Whether the transform and its inverse map finite floats to finite floats.
bool isUsable(const Transform& t);
// Whether all coordinates are within limits::kCoordinate. False for bounds with NaN.
bool isWithinReach(const Bounds& bounds);

// The cost of the texture that params describe, given the cost of the textures that it uses. Throws Error if the cost
// is too high.
std::shared_ptr<const TextureCost> costAbove(const TextureCost& others, const ParamSet& params);
// Throws Error at pos if rays cannot be transformed to the space of an object with this placement: their coordinates
// must stay below limits::kCoordinate, and Embree must be able to invert the transform in floats.
void checkPlacement(const AnimatedTransform& objectToWorld, const SourcePos& pos);
// Throws Error at pos if Attribute sets too many values for objects of this target ("shape").
void checkShared(const ParamSet& params, const std::string& target, const SourcePos& pos);

}  // namespace drc::pbrt
