#include "scene/scene_placements.h"

namespace drc {

void ScenePlacements::add(uint32_t number, const AnimatedTransform& toWorld) {
    if (number == 0) return;
    if (toWorld.isAnimated())
        moving_.emplace_back(number, toWorld);
    else
        still_.add(number, toWorld.start());
}

ObjectPlacements ScenePlacements::at(float time) const {
    ObjectPlacements moved;
    for (const auto& [number, toWorld] : moving_) moved.add(number, toWorld.at(time));
    return still_.with(moved);
}

}  // namespace drc
