// Types for furniture: the tools that build a piece, and the table entry that says where it belongs.
#pragma once
#include <array>

#include "generator_materials.h"
#include "generator_pen.h"
#include "generator_rng.h"

namespace drc::interior {

// A piece extends in x from -w/2 to w/2; its back is at y = 0 and its front at y = depth.
struct Kit {
    const Pen& pen;
    Vec3 size;
    Rng& rng;
    const Palette& palette;

    int wood() const { return rng.pick(palette.furniture); }
    int cloth() const { return rng.pick(palette.fabric); }
    int metal() const { return rng.pick(palette.metal); }
    int ornament() const { return rng.pick(palette.ornament); }
    Vec3 middle() const { return {0, size.y / 2, 0}; }
};

struct Piece {
    void (*build)(const Kit&);
    Vec3 least, most;
    bool atWall;
    std::array<float, 5> weight;  // relative frequency, by RoomKind
};

}  // namespace drc::interior
