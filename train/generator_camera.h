// Chooses a random camera position and target.
#pragma once
#include "generator_room.h"

namespace drc::interior {

// False if no position was found because the room is too full.
bool placeCamera(const Room& room, Draft& draft, Rng& rng);

}  // namespace drc::interior
