// What a room's surfaces are made of. A palette is drawn once a room, and furniture picks from it, as a home has a few
// materials that recur.
#pragma once
#include <vector>

#include "generator_draft.h"
#include "generator_rng.h"

namespace drc::interior {

// What a room is for: it decides the plan, the walls and the furniture.
enum class RoomKind { Living, Corridor, Bath, Kitchen, Hall };

struct Palette {
    int wall = 0, accentWall = 0, floor = 0, ceiling = 0, trim = 0, ground = 0;
    int lightBody = 0;  // what an emitter is made of: black
    std::vector<int> furniture, fabric, metal, ornament, paper, shade;
    int glass = 0, pane = 0, mirror = 0, leaf = 0, stem = 0;
};

Palette makePalette(Draft& draft, Rng& rng, RoomKind kind);
// A material of its own for one picture.
int makePainting(Draft& draft, Rng& rng);
// Any everyday colour; `saturation` 0 is grey.
Rgb randomAlbedo(Rng& rng, float lo, float hi, float saturation);

}  // namespace drc::interior
