// Where the numbered objects of a scene are, at any time of their motion.
#pragma once
#include <utility>
#include <vector>

#include "image/object_placements.h"
#include "math/animated_transform.h"

namespace drc {

class ScenePlacements {
  public:
    // 0, which is no object's number, is ignored. toWorld: to the file's world space.
    void add(uint32_t number, const AnimatedTransform& toWorld);
    // time: as Ray::time.
    ObjectPlacements at(float time) const;

  private:
    ObjectPlacements still_;
    std::vector<std::pair<uint32_t, AnimatedTransform>> moving_;
};

}  // namespace drc
