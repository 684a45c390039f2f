// Lamps, and the distribution of light among all emitters.
#pragma once
#include "generator_room.h"

namespace drc::interior {

// Places zero to three kinds of lamps; at least one if nothing else emits light.
void placeLamps(const Room& room, Draft& draft, Rng& rng, const Palette& palette, const ShellLight& shell, int& groups);

// Gives each group of emitters a share of a total flux that suits the size of the room. Removes lights that no longer
// face free space because furniture was placed in front of them.
void balanceLight(const Room& room, Draft& draft, Rng& rng, const ShellLight& shell, int groups);

}  // namespace drc::interior
