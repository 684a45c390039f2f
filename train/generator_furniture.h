// Furniture on the floor. A new piece is a function and a line in the table of generator_furniture.cpp.
#pragma once
#include "generator_room.h"

namespace drc::interior {

// Fills about `share` of the room's floor.
void furnish(Room& room, Draft& draft, Rng& rng, const Palette& palette, RoomKind kind, float share);

// Scatters loose primitives instead of furniture, for geometry that no furniture has.
void scatterPrimitives(const Room& room, Draft& draft, Rng& rng, const Palette& palette, int count);

}  // namespace drc::interior
