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
// Rays are intersected in the space of the object: their coordinates must stay below limits::kCoordinate there.
bool isInstanceable(const Transform& objectToWorld);
// At all times, and what it stretches can be found in floats between them too: see limits::kMovingStretch.
bool isMovable(const AnimatedTransform& objectToWorld);
// False also for what has no bounds: made of what is no number.
bool isWithinReach(const Bounds& bounds);

// Of the texture that params describe, which asks for others at that cost. Throws Error if it is too much.
std::shared_ptr<const TextureCost> costAbove(const TextureCost& others, const ParamSet& params);
// Throws Error, at pos, if what all things of this target ("shape") get a copy of is too much.
void checkShared(const ParamSet& params, const std::string& target, const SourcePos& pos);

}  // namespace drc::pbrt
