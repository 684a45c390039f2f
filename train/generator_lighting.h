// Lamps, and how bright everything is.
#pragma once
#include "generator_room.h"

namespace drc::interior {

// Hangs and stands lamps, of zero to three kinds; at least one if nothing else shines.
void placeLamps(const Room& room, Draft& draft, Rng& rng, const Palette& palette, const ShellLight& shell, int& groups);

// Gives every group its share of a flux that suits the size of the room. Lights that no longer shine into free space
// (furniture came in their way) are taken out.
void balanceLight(const Room& room, Draft& draft, Rng& rng, const ShellLight& shell, int groups);

}  // namespace drc::interior
