// What the front end refuses although pbrt's format allows it, because no machine could render it: see limits.h.
#pragma once
#include <memory>

#include "math/animated_transform.h"
#include "pbrt/param_set.h"
#include "pbrt/texture_params.h"
#include "scene/shape.h"

namespace drc::pbrt {

// Takes floats to floats, and back.
bool isUsable(const Transform& t);
// False also for what has no bounds: made of what is no number.
bool isWithinReach(const Bounds& bounds);

// Of the texture that params describe, which asks for others at that cost. Throws Error if it is too much.
std::shared_ptr<const TextureCost> costAbove(const TextureCost& others, const ParamSet& params);
// Throws Error, at pos, if rays cannot be taken to the space of an object that is placed so: their coordinates must
// stay below limits::kCoordinate there, and Embree finds the inverse in floats.
void checkPlacement(const AnimatedTransform& objectToWorld, const SourcePos& pos);
// Throws Error, at pos, if what all things of this target ("shape") get a copy of is too much.
void checkShared(const ParamSet& params, const std::string& target, const SourcePos& pos);

}  // namespace drc::pbrt
