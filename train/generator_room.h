// The shell: floor plan, walls with their openings, ceiling, pillars, and what can be seen through the openings.
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

// A wall's frame: x along the wall, y into the room, z up.
struct Wall {
    Placement frame;
    float length = 0;
    bool reentrant = false;  // towards the notch of an L: what lies behind it is outside, but close to another wall
    int material = 0;
    // How far it is drawn beyond its ends, behind the neighbouring wall, so that no ray slips through the corner.
    float startLap = 0, endLap = 0;
    std::vector<Opening> openings;
    struct Use {
        float u0, u1, z0, z1;
    };
    std::vector<Use> uses;

    bool isFree(const Use& use) const;
    // A place of this width somewhere along the wall, marked as used; none if none was found.
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
    std::vector<Opening> skylights;  // of a flat ceiling: u is x, and z0, z1 stand for y

    float ceilingAt(float x) const;
    bool contains(float x, float y, float margin) const;
    float floorArea() const;
    float surfaceArea() const;
    // Distance to the shell, its openings taken as closed.
    float hit(const Vec3& origin, const Vec3& direction) const;
};

// Light that comes through openings; what it amounts to is decided later.
struct ShellLight {
    int panelGroup = -1;
    int corridorGroup = -1;
    int nicheGroup = -1;
    int hearthGroup = -1;
    float skyArea = 0;  // of openings to the sky
    Vec3 skyWindowOut{0, 0, 0};
};

Room makeRoom(Rng& rng, const Palette& palette, RoomKind kind);
// Chooses openings, then draws it all. groups counts the emitter groups given out so far.
ShellLight buildShell(Room& room, Draft& draft, Rng& rng, const Palette& palette, int& groups);

}  // namespace drc::interior
