// The materials of a room. A palette is chosen per room, from which all furniture picks, since a real home reuses a few
// materials.
#pragma once
#include <vector>

#include "generator_draft.h"
#include "generator_rng.h"

namespace drc::interior {

// The purpose of a room. It determines floor plan, walls and furniture.
enum class RoomKind { Living, Corridor, Bath, Kitchen, Hall };

struct Palette {
    int wall = 0, accentWall = 0, floor = 0, ceiling = 0, trim = 0, ground = 0;
    int lightBody = 0;  // the black material of emitters
    std::vector<int> furniture, fabric, metal, ornament, paper, shade;
    int glass = 0, pane = 0, mirror = 0, leaf = 0, stem = 0;
};

Palette makePalette(Draft& draft, Rng& rng, RoomKind kind);
// A separate material for each picture.
int makePainting(Draft& draft, Rng& rng);
// A random everyday colour; `saturation` 0 is grey.
Rgb randomAlbedo(Rng& rng, float lo, float hi, float saturation);

}  // namespace drc::interior
