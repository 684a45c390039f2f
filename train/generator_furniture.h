// Things that stand on the floor. A new piece is one function and one line of the table in generator_furniture.cpp.
#pragma once
#include "generator_room.h"

namespace drc::interior {

// Fills the room to about `share` of its floor.
void furnish(Room& room, Draft& draft, Rng& rng, const Palette& palette, RoomKind kind, float share);

// Loose primitives instead of furniture: for what no furniture teaches.
void scatterPrimitives(const Room& room, Draft& draft, Rng& rng, const Palette& palette, int count);

}  // namespace drc::interior
