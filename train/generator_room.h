// The shell of a room: floor plan, walls with openings, ceiling, pillars, and the surroundings visible through the
// openings.
#pragma once
#include <optional>
#include <vector>

#include "generator_draft.h"
#include "generator_materials.h"
#include "generator_pen.h"
#include "generator_rng.h"

namespace drc::interior {

enum class OpeningKind { Sky, LightPanel, Niche, Alcove, DoorAjar, Hearth };
enum class CeilingKind { Flat, Shed, Gable };

struct Opening {
    OpeningKind kind;
    float u0, u1, z0, z1;
    float depth;
};

// A wall. Its frame has x along the wall, y into the room and z up.
struct Wall {
    Placement frame;
    float length = 0;
    bool reentrant = false;  // borders the notch of an L: the outside behind it is close to another wall
    int material = 0;
    // How far the wall extends beyond its ends, behind the neighbouring walls, so that no ray slips through the corner.
    float startLap = 0, endLap = 0;
    std::vector<Opening> openings;
    struct Use {
        float u0, u1, z0, z1;
    };
    std::vector<Use> uses;

    bool isFree(const Use& use) const;
    // Reserves a free place of this width along the wall; none if there is none.
    std::optional<float> reserve(Rng& rng, float width, float z0, float z1, float margin);
};

struct Room {
    struct Rect {
        float x0, y0, x1, y1;
    };
    std::vector<Rect> rects;
    std::vector<Wall> walls;
    float width = 0, depth = 0;
    float eaves = 0;  // lowest height of the ceiling
    float rise = 0;
    CeilingKind ceiling = CeilingKind::Flat;
    std::vector<Opening> skylights;  // in a flat ceiling; u is x, and z0 and z1 are y

    float ceilingAt(float x) const;
    bool contains(float x, float y, float margin) const;
    float floorArea() const;
    float surfaceArea() const;
    // Distance to the shell with its openings closed.
    float hit(const Vec3& origin, const Vec3& direction) const;
};

// Light that enters through openings; its intensity is set later by balanceLight().
struct ShellLight {
    int panelGroup = -1;
    int corridorGroup = -1;
    int nicheGroup = -1;
    int hearthGroup = -1;
    float skyArea = 0;  // total area of openings to the sky
    Vec3 skyWindowOut{0, 0, 0};
};

Room makeRoom(Rng& rng, const Palette& palette, RoomKind kind);
// Chooses the openings and builds the whole shell. `groups` is the number of emitter groups used so far.
ShellLight buildShell(Room& room, Draft& draft, Rng& rng, const Palette& palette, int& groups);

}  // namespace drc::interior
