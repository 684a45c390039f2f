// Small objects on tables and shelves, on walls, at windows and on the floor.
#pragma once
#include "generator_room.h"

namespace drc::interior {

void placeOrnaments(Draft& draft, Rng& rng, const Palette& palette, float density);
void decorateWalls(Room& room, Draft& draft, Rng& rng, const Palette& palette);
void dressWindows(const Room& room, Draft& draft, Rng& rng, const Palette& palette);
void layRug(const Room& room, Draft& draft, Rng& rng, const Palette& palette);

}  // namespace drc::interior
