// Finds a place to stand and something to look at.
#pragma once
#include "generator_room.h"

namespace drc::interior {

// False if no place was found: the room is too full.
bool placeCamera(const Room& room, Draft& draft, Rng& rng);

}  // namespace drc::interior
