#include "generator_room.h"

#include <algorithm>

namespace drc::interior {
namespace {

constexpr float kDoorHeight = 2.05f;
constexpr float kCorridorSide = 0.7f;

Wall makeWall(const Vec2& a, const Vec2& b, int material) {
    Wall w;
    const Vec2 d = b - a;
    w.length = std::abs(d.x) + std::abs(d.y);
    // Walls are parallel to the axes; exact directions keep the corners closed.
    w.frame = {Vec3(a.x, a.y, 0), d.x > 0 ? 1.f : d.x < 0 ? -1.f : 0.f, d.y > 0 ? 1.f : d.y < 0 ? -1.f : 0.f};
    w.material = material;
    return w;
}

// A piece of wall that faces the room (+y) or away from it.
void wallQuad(const Pen& pen, float u0, float u1, float z0, float z1, float y, int material, bool intoRoom = true) {
    if (intoRoom) {
        pen.quad({u1, y, z0}, {u0, y, z0}, {u0, y, z1}, {u1, y, z1}, material);
    } else {
        pen.quad({u0, y, z0}, {u1, y, z0}, {u1, y, z1}, {u0, y, z1}, material);
    }
}

// A wall with openings, as a grid of cells whose lines are the openings' edges.
void perforatedWall(const Pen& pen, const std::vector<Opening>& openings, float u0, float u1, float z0, float z1,
                    float y, int material, bool intoRoom) {
    std::vector<float> us{u0, u1}, zs{z0, z1};
    for (const Opening& o : openings) {
        us.insert(us.end(), {o.u0, o.u1});
        zs.insert(zs.end(), {o.z0, o.z1});
    }
    for (auto* v : {&us, &zs}) {
        std::sort(v->begin(), v->end());
        v->erase(std::unique(v->begin(), v->end()), v->end());
    }
    for (size_t i = 0; i + 1 < us.size(); ++i) {
        for (size_t j = 0; j + 1 < zs.size(); ++j) {
            const float u = (us[i] + us[i + 1]) / 2, z = (zs[j] + zs[j + 1]) / 2;
            const bool open = std::any_of(openings.begin(), openings.end(), [&](const Opening& o) {
                return u > o.u0 && u < o.u1 && z > o.z0 && z < o.z1;
            });
            if (!open) wallQuad(pen, us[i], us[i + 1], zs[j], zs[j + 1], y, material, intoRoom);
        }
    }
}

// A ceiling with openings, seen from below, as a grid like that of perforatedWall().
void perforatedCeiling(const Pen& pen, const std::vector<Opening>& openings, float x0, float x1, float y0, float y1,
                       float z, int material) {
    // Treated as a wall lying on its back: z of the opening becomes y.
    std::vector<float> xs{x0, x1}, ys{y0, y1};
    for (const Opening& o : openings) {
        xs.insert(xs.end(), {o.u0, o.u1});
        ys.insert(ys.end(), {o.z0, o.z1});
    }
    std::sort(xs.begin(), xs.end());
    std::sort(ys.begin(), ys.end());
    for (size_t i = 0; i + 1 < xs.size(); ++i) {
        for (size_t j = 0; j + 1 < ys.size(); ++j) {
            const float x = (xs[i] + xs[i + 1]) / 2, y = (ys[j] + ys[j + 1]) / 2;
            const bool open = std::any_of(openings.begin(), openings.end(), [&](const Opening& o) {
                return x > o.u0 && x < o.u1 && y > o.z0 && y < o.z1;
            });
            if (open) continue;
            pen.quad({xs[i], ys[j + 1], z}, {xs[i + 1], ys[j + 1], z}, {xs[i + 1], ys[j], z}, {xs[i], ys[j], z},
                     material);
        }
    }
}

// The shaft above a skylight.
void skylight(const Opening& o, float z, Draft& draft, const Palette& palette, ShellLight& light) {
    const Pen pen(draft, {});
    const int m = palette.ceiling;
    const float top = z + o.depth;
    pen.quad({o.u0, o.z0, z}, {o.u0, o.z0, top}, {o.u0, o.z1, top}, {o.u0, o.z1, z}, m);
    pen.quad({o.u1, o.z1, z}, {o.u1, o.z1, top}, {o.u1, o.z0, top}, {o.u1, o.z0, z}, m);
    pen.quad({o.u1, o.z0, z}, {o.u1, o.z0, top}, {o.u0, o.z0, top}, {o.u0, o.z0, z}, m);
    pen.quad({o.u0, o.z1, z}, {o.u0, o.z1, top}, {o.u1, o.z1, top}, {o.u1, o.z1, z}, m);
    draft.freeVolumes.push_back({{}, {o.u0, o.z0, z}, {o.u1, o.z1, top + 0.001f}});
    light.skyArea += (o.u1 - o.u0) * (o.z1 - o.z0);
    light.skyWindowOut = Vec3(0, 0, 1);
}

// The four sides of an opening through the wall, facing inwards.
void reveal(const Pen& pen, const Opening& o, int sides, int floor) {
    const float d = -o.depth;
    pen.quad({o.u0, d, o.z0}, {o.u1, d, o.z0}, {o.u1, 0, o.z0}, {o.u0, 0, o.z0}, floor);
    pen.quad({o.u0, 0, o.z1}, {o.u1, 0, o.z1}, {o.u1, d, o.z1}, {o.u0, d, o.z1}, sides);
    pen.quad({o.u0, d, o.z0}, {o.u0, 0, o.z0}, {o.u0, 0, o.z1}, {o.u0, d, o.z1}, sides);
    pen.quad({o.u1, 0, o.z0}, {o.u1, d, o.z0}, {o.u1, d, o.z1}, {o.u1, 0, o.z1}, sides);
}

void windowFrame(const Pen& pen, const Opening& o, Rng& rng, const Palette& palette, bool pane) {
    const float w = rng.uniform(0.03f, 0.07f);
    const float y0 = -o.depth * 0.5f - 0.025f, y1 = y0 + 0.05f;
    const int m = palette.trim;
    pen.box({o.u0, y0, o.z0}, {o.u1, y1, o.z0 + w}, m);
    pen.box({o.u0, y0, o.z1 - w}, {o.u1, y1, o.z1}, m);
    pen.box({o.u0, y0, o.z0 + w}, {o.u0 + w, y1, o.z1 - w}, m);
    pen.box({o.u1 - w, y0, o.z0 + w}, {o.u1, y1, o.z1 - w}, m);
    const int columns = std::max(1, static_cast<int>(std::lround((o.u1 - o.u0) / rng.uniform(0.4f, 1.2f))));
    for (int i = 1; i < columns; ++i) {
        const float u = lerp(static_cast<float>(i) / static_cast<float>(columns), o.u0, o.u1);
        pen.box({u - w / 3, y0 + 0.01f, o.z0 + w}, {u + w / 3, y1 - 0.01f, o.z1 - w}, m);
    }
    if (rng.chance(0.5f)) {
        const float z = lerp(rng.uniform(0.4f, 0.75f), o.z0, o.z1);
        pen.box({o.u0 + w, y0 + 0.012f, z - w / 3}, {o.u1 - w, y1 - 0.012f, z + w / 3}, m);
    }
    if (pane) {
        const float y = (y0 + y1) / 2;
        const size_t solids = pen.draft().solids.size();
        pen.box({o.u0 + w * 0.8f, y - 0.003f, o.z0 + w * 0.8f}, {o.u1 - w * 0.8f, y + 0.003f, o.z1 - w * 0.8f},
                palette.pane);
        pen.draft().solids.resize(solids);  // it is transparent
    }
    // A sill that projects into the room.
    if (rng.chance(0.6f) && o.z0 > 0.2f)
        pen.box({o.u0 - 0.04f, -0.01f, o.z0 - 0.03f}, {o.u1 + 0.04f, rng.uniform(0.04f, 0.2f), o.z0}, m);
}

void corridor(const Pen& pen, const Opening& o, Rng& rng, const Palette& palette, int group) {
    const float y0 = -o.depth - rng.uniform(1.2f, 2), y1 = -o.depth;
    const float u0 = o.u0 - kCorridorSide + 0.1f, u1 = o.u1 + kCorridorSide - 0.1f, top = kDoorHeight + 0.35f;
    const int m = palette.accentWall;
    perforatedWall(pen, {o}, u0, u1, 0, top, y1, m, false);
    wallQuad(pen, u0, u1, 0, top, y0, m);
    pen.quad({u0, y0, 0}, {u1, y0, 0}, {u1, y1, 0}, {u0, y1, 0}, palette.floor);
    pen.quad({u0, y1, top}, {u1, y1, top}, {u1, y0, top}, {u0, y0, top}, palette.ceiling);
    pen.quad({u0, y0, 0}, {u0, y1, 0}, {u0, y1, top}, {u0, y0, top}, m);
    pen.quad({u1, y1, 0}, {u1, y0, 0}, {u1, y0, top}, {u1, y1, top}, m);
    const float s = rng.uniform(0.1f, 0.3f);
    pen.quadLight({(u0 + u1) / 2, (y0 + y1) / 2, top - 0.02f}, {0, s, 0}, {s, 0, 0}, group, palette.lightBody);
    pen.draft().freeVolumes.push_back({pen.frame(), {u0, y0, 0}, {u1, y1, top}});
    // The door leaf opens away from the room, hinged at the near edge of the frame.
    const float angle = rng.uniform(0.25f, 1.2f);
    const Pen leaf = pen.inner({o.u0 + 0.01f, y1 - 0.01f, 0}, -angle);
    leaf.box({0, -0.04f, 0.01f}, {o.u1 - o.u0 - 0.03f, 0, o.z1 - 0.01f}, palette.trim);
}

void chooseOpenings(Room& room, Rng& rng, bool sky) {
    const auto cut = [&](Wall& wall, OpeningKind kind, float width, float z0, float z1, float depth, float margin) {
        if (z1 > room.eaves - 0.05f || width > wall.length - 2 * margin) return false;
        const auto u = wall.reserve(rng, width, z0, z1, margin);
        if (u) wall.openings.push_back({kind, *u, *u + width, z0, z1, depth});
        return u.has_value();
    };
    const auto anyWall = [&]() -> Wall& {
        return room.walls[static_cast<size_t>(rng.integer(0, static_cast<int>(room.walls.size()) - 1))];
    };
    if (rng.chance(0.45f)) {
        Wall& w = anyWall();
        if (!w.reentrant) {
            const float width = rng.uniform(0.75f, 0.95f), depth = rng.uniform(0.1f, 0.25f);
            cut(w, OpeningKind::DoorAjar, width, 0, kDoorHeight, depth, kCorridorSide + 0.05f);
        }
    }
    if (rng.chance(0.25f)) {
        Wall& w = anyWall();
        if (!w.reentrant) {
            const float top = std::min(rng.uniform(1.9f, 2.6f), room.eaves - 0.1f);
            const float width = rng.uniform(0.8f, 2.2f), depth = rng.uniform(0.4f, 1.5f);
            cut(w, OpeningKind::Alcove, width, 0, top, depth, kCorridorSide);
        }
    }
    if (rng.chance(0.07f)) {
        Wall& w = anyWall();
        if (!w.reentrant) {
            const float width = rng.uniform(0.6f, 1.3f), top = rng.uniform(0.5f, 1), depth = rng.uniform(0.3f, 0.6f);
            cut(w, OpeningKind::Hearth, width, 0, top, depth, kCorridorSide);
        }
    }
    const int windows = rng.integer(0, 4);
    for (int i = 0; i < windows; ++i) {
        Wall& w = anyWall();
        const bool tall = rng.chance(0.3f);
        const float z0 = tall ? rng.uniform(0.02f, 0.2f) : rng.uniform(0.5f, 1.3f);
        const float z1 = std::min(room.eaves - 0.1f, z0 + (tall ? rng.uniform(1.8f, 2.6f) : rng.uniform(0.5f, 1.6f)));
        const float width = rng.uniform(0.4f, 2.6f), depth = rng.uniform(0.12f, 0.45f);
        cut(w, sky ? OpeningKind::Sky : OpeningKind::LightPanel, width, z0, z1, depth, 0.2f);
    }
    for (int i = rng.integer(0, 2); i > 0; --i) {
        const float z0 = rng.uniform(0.6f, 1.3f), z1 = z0 + rng.uniform(0.25f, 1);
        const float width = rng.uniform(0.3f, 1.5f), depth = rng.uniform(0.1f, 0.35f);
        cut(anyWall(), OpeningKind::Niche, width, z0, z1, depth, 0.4f);
    }
}

void buildOpening(const Wall& wall, const Opening& o, Draft& draft, Rng& rng, const Palette& palette, ShellLight& light,
                  int& groups) {
    const Pen pen(draft, wall.frame);
    const bool toFloor = o.z0 == 0;
    reveal(pen, o, o.kind == OpeningKind::Niche ? palette.accentWall : wall.material,
           toFloor ? palette.floor : palette.trim);
    draft.freeVolumes.push_back({wall.frame, {o.u0, -o.depth - 0.001f, o.z0}, {o.u1, 0, o.z1}});
    const auto group = [&](int& g) { return g >= 0 ? g : (g = groups++); };
    switch (o.kind) {
        case OpeningKind::Sky:
            windowFrame(pen, o, rng, palette, rng.chance(0.2f));
            light.skyArea += (o.u1 - o.u0) * (o.z1 - o.z0);
            light.skyWindowOut = wall.frame.vector({0, -1, 0});
            break;
        case OpeningKind::LightPanel:
            windowFrame(pen, o, rng, palette, rng.chance(0.15f));
            pen.quadLight({(o.u0 + o.u1) / 2, -o.depth, (o.z0 + o.z1) / 2}, {0, 0, (o.z1 - o.z0) / 2},
                          {(o.u1 - o.u0) / 2, 0, 0}, group(light.panelGroup), palette.lightBody);
            break;
        case OpeningKind::Niche: {
            wallQuad(pen, o.u0, o.u1, o.z0, o.z1, -o.depth, palette.accentWall);
            pen.surface({(o.u0 + o.u1) / 2, -o.depth / 2, o.z0}, (o.u1 - o.u0) / 2 - 0.02f, o.depth / 2 - 0.02f,
                        o.z1 - o.z0 - 0.06f);
            if (rng.chance(0.5f)) {
                pen.quadLight({(o.u0 + o.u1) / 2, -o.depth / 2, o.z1 - 0.01f}, {0, o.depth * 0.3f, 0},
                              {(o.u1 - o.u0) * 0.35f, 0, 0}, group(light.nicheGroup), palette.lightBody);
            }
            break;
        }
        case OpeningKind::Alcove:
            wallQuad(pen, o.u0, o.u1, o.z0, o.z1, -o.depth, palette.accentWall);
            break;
        case OpeningKind::Hearth:
            wallQuad(pen, o.u0, o.u1, o.z0, o.z1, -o.depth, palette.accentWall);
            for (int i = rng.integer(3, 9); i > 0; --i) {  // embers
                const float r = rng.uniform(0.02f, 0.06f);
                pen.sphereLight({rng.uniform(o.u0 + 0.15f, o.u1 - 0.15f), -o.depth * rng.uniform(0.3f, 0.7f),
                                 r + rng.uniform(0.01f, 0.25f)},
                                r, group(light.hearthGroup), palette.lightBody);
            }
            break;
        case OpeningKind::DoorAjar:
            corridor(pen, o, rng, palette, group(light.corridorGroup));
            break;
    }
}

// Floor and ceiling extend slightly beyond the walls, so that no ray slips through the seam.
void floorAndCeiling(const Room& room, const Pen& pen, const Palette& palette) {
    constexpr float kLap = 0.02f;
    for (const Room::Rect& r : room.rects) {
        const float x0 = r.x0 - kLap, x1 = r.x1 + kLap, y0 = r.y0 - kLap, y1 = r.y1 + kLap;
        pen.quad({x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}, palette.floor);
        std::vector<float> xs{x0, x1};
        const float ridge = room.width / 2;
        if (room.ceiling == CeilingKind::Gable && ridge > x0 && ridge < x1) xs.insert(xs.begin() + 1, ridge);
        if (!room.skylights.empty()) {
            perforatedCeiling(pen, room.skylights, x0, x1, y0, y1, room.eaves, palette.ceiling);
            continue;
        }
        for (size_t i = 0; i + 1 < xs.size(); ++i) {
            const float a = xs[i], b = xs[i + 1], za = room.ceilingAt(a), zb = room.ceilingAt(b);
            pen.quad({a, y1, za}, {b, y1, zb}, {b, y0, zb}, {a, y0, za}, palette.ceiling);
        }
    }
}

// The part of a wall above the eaves, below a sloped ceiling.
void gableEnd(const Room& room, const Wall& wall, const Pen& pen) {
    if (room.ceiling == CeilingKind::Flat) return;
    std::vector<float> us{0, wall.length};
    if (wall.frame.cosYaw != 0 && room.ceiling == CeilingKind::Gable) {
        const float u = (room.width / 2 - wall.frame.origin.x) * wall.frame.cosYaw;
        if (u > 0 && u < wall.length) us.insert(us.begin() + 1, u);
    }
    for (size_t i = 0; i + 1 < us.size(); ++i) {
        const float a = us[i], b = us[i + 1];
        const float za = room.ceilingAt(wall.frame.point({a, 0, 0}).x),
                    zb = room.ceilingAt(wall.frame.point({b, 0, 0}).x);
        // A triangle where the ceiling meets the eaves.
        if (zb - room.eaves < 1e-4f && za - room.eaves < 1e-4f) continue;
        if (za - room.eaves < 1e-4f) {
            pen.triangle({b, 0, room.eaves}, {a, 0, room.eaves}, {b, 0, zb}, wall.material);
        } else if (zb - room.eaves < 1e-4f) {
            pen.triangle({b, 0, room.eaves}, {a, 0, room.eaves}, {a, 0, za}, wall.material);
        } else {
            pen.quad({b, 0, room.eaves}, {a, 0, room.eaves}, {a, 0, za}, {b, 0, zb}, wall.material);
        }
    }
}

void skirting(const Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    const float height = rng.uniform(0.05f, 0.16f), thickness = rng.uniform(0.008f, 0.02f);
    for (const Wall& w : room.walls) {
        if (std::any_of(w.openings.begin(), w.openings.end(), [&](const Opening& o) { return o.z0 < height; }))
            continue;
        Pen(draft, w.frame).box({0, -0.001f, -0.001f}, {w.length, thickness, height}, palette.trim);
    }
}

void pillarsAndBeams(const Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    const Pen pen(draft, {});
    const int material = rng.chance(0.5f) ? palette.wall : rng.pick(palette.furniture);
    if (rng.chance(0.25f)) {
        for (int i = rng.integer(1, 4); i > 0; --i) {
            const float x = rng.uniform(0.4f, room.width - 0.4f), y = rng.uniform(0.4f, room.depth - 0.4f),
                        r = rng.uniform(0.1f, 0.25f);
            if (!room.contains(x, y, r + 0.3f)) continue;
            const float top = room.ceilingAt(x) + (room.rise > 0 ? 0.3f : 0);
            if (rng.chance(0.5f)) {
                pen.box({x - r, y - r, 0}, {x + r, y + r, top}, material);
            } else {
                pen.cylinder({x, y, 0}, r, top, material);
            }
            draft.footprints.push_back({{}, {x - r, y - r, 0}, {x + r, y + r, top}});
        }
    }
    if (room.ceiling == CeilingKind::Flat && rng.chance(0.2f)) {
        const int count = rng.integer(2, 6);
        for (int i = 0; i < count; ++i) {
            const float y = room.depth * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            pen.box({-0.01f, y - 0.08f, room.eaves - 0.2f}, {room.width + 0.01f, y + 0.08f, room.eaves + 0.01f},
                    material);
        }
    }
}

// The surroundings outside: ground, and sometimes a building across the street.
void outside(const Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    const Pen pen(draft, {});
    const float level = -rng.uniform(0.3f, 9);
    const size_t solids = draft.solids.size();
    pen.quad({-60, -60, level}, {60, -60, level}, {60, 60, level}, {-60, 60, level}, palette.ground);
    for (const Wall& w : room.walls) {
        if (!rng.chance(0.35f)) continue;
        const float away = rng.uniform(4, 15), half = rng.uniform(2, 9);
        Pen(draft, w.frame)
            .box({w.length / 2 - half, -away - 3, level}, {w.length / 2 + half, -away, rng.uniform(1, 9)},
                 palette.accentWall);
    }
    draft.solids.resize(solids);
}

}  // namespace

bool Wall::isFree(const Use& use) const {
    return std::none_of(uses.begin(), uses.end(),
                        [&](const Use& o) { return use.u0 < o.u1 && o.u0 < use.u1 && use.z0 < o.z1 && o.z0 < use.z1; });
}

std::optional<float> Wall::reserve(Rng& rng, float width, float z0, float z1, float margin) {
    if (width + 2 * margin > length) return {};
    for (int attempt = 0; attempt < 12; ++attempt) {
        const float u = rng.uniform(margin, length - width - margin);
        if (!isFree({u - margin, u + width + margin, z0, z1})) continue;
        uses.push_back({u, u + width, z0, z1});
        return u;
    }
    return {};
}

float Room::ceilingAt(float x) const {
    switch (ceiling) {
        case CeilingKind::Flat:
            return eaves;
        case CeilingKind::Shed:
            return eaves + rise * x / width;
        case CeilingKind::Gable:
            return eaves + rise * (1 - std::abs(2 * x / width - 1));
    }
    return eaves;
}

bool Room::contains(float x, float y, float margin) const {
    for (const float dx : {-margin, margin}) {
        for (const float dy : {-margin, margin}) {
            const float px = x + dx, py = y + dy;
            if (std::none_of(rects.begin(), rects.end(),
                             [&](const Rect& r) { return px >= r.x0 && px <= r.x1 && py >= r.y0 && py <= r.y1; }))
                return false;
        }
    }
    return true;
}

float Room::floorArea() const {
    float area = 0;
    for (const Rect& r : rects) area += (r.x1 - r.x0) * (r.y1 - r.y0);
    return area;
}

float Room::surfaceArea() const {
    float area = 2 * floorArea();
    for (const Wall& w : walls) area += w.length * (eaves + rise / 2);
    return area;
}

float Room::hit(const Vec3& origin, const Vec3& direction) const {
    float nearest = kInfinity;
    const float top = eaves + rise / 2;
    if (direction.z < -1e-6f) nearest = -origin.z / direction.z;
    if (direction.z > 1e-6f) nearest = (top - origin.z) / direction.z;
    for (const Wall& w : walls) {
        const Vec3 o = w.frame.toLocal(origin);
        const Vec3 d = w.frame.toLocal(w.frame.origin + direction);
        if (d.y >= -1e-6f || o.y <= 0) continue;
        const float t = -o.y / d.y, u = o.x + t * d.x;
        if (u >= 0 && u <= w.length) nearest = std::min(nearest, t);
    }
    return nearest;
}

Room makeRoom(Rng& rng, const Palette& palette, RoomKind purpose) {
    Room r;
    r.width = rng.uniform(2.5f, 7.5f);
    r.depth = rng.uniform(2.5f, 7.5f);
    if (rng.chance(0.15f)) r.depth = rng.uniform(7, 9);
    if (rng.chance(0.1f)) r.width = 2.5f * rng.uniform(0.7f, 1);
    r.eaves = rng.chance(0.75f) ? rng.uniform(2.3f, 3) : rng.uniform(3, 4.2f);
    switch (purpose) {
        case RoomKind::Corridor:
            r.width = rng.chance(0.7f) ? rng.uniform(1.2f, 2.2f) : rng.uniform(3.3f, 5);  // wide corridors are L-shaped
            r.depth = rng.uniform(5, 11);
            break;
        case RoomKind::Bath:
            r.width = rng.uniform(1.8f, 3.6f);
            r.depth = rng.uniform(1.8f, 4);
            break;
        case RoomKind::Hall:
            r.width = rng.uniform(6, 12);
            r.depth = rng.uniform(6, 12);
            r.eaves = rng.uniform(3, 6.5f);
            break;
        default:
            break;
    }
    const float kind = rng.uniform();
    if (kind > 0.7f && purpose != RoomKind::Corridor) {
        r.ceiling = kind > 0.85f ? CeilingKind::Gable : CeilingKind::Shed;
        r.eaves = rng.uniform(2.2f, 2.7f);
        r.rise = rng.uniform(0.3f, 1.8f);
    }
    std::vector<Vec2> plan;
    const float w = r.width, d = r.depth;
    const bool isL = w > 3.2f && d > 3.2f && (purpose == RoomKind::Corridor || rng.chance(0.5f));
    if (isL) {
        // Both arms of an L-shaped corridor are narrow.
        const float cut = purpose == RoomKind::Corridor ? rng.uniform(0.55f, 0.65f) : rng.uniform(0.25f, 0.55f);
        const float cw = w * cut, cd = d * (purpose == RoomKind::Corridor ? 1 - 1.5f / d : rng.uniform(0.25f, 0.55f));
        plan = {{0, 0}, {w, 0}, {w, d - cd}, {w - cw, d - cd}, {w - cw, d}, {0, d}};
        r.rects = {{0, 0, w, d - cd}, {0, d - cd, w - cw, d}};
    } else {
        plan = {{0, 0}, {w, 0}, {w, d}, {0, d}};
        r.rects = {{0, 0, w, d}};
    }
    const bool accent = rng.chance(0.4f);
    const int accentWall = rng.integer(0, static_cast<int>(plan.size()) - 1);
    if (r.ceiling == CeilingKind::Flat && !isL && w > 1.6f && rng.chance(purpose == RoomKind::Living ? 0.12f : 0.2f)) {
        const float hx = rng.uniform(0.2f, w * 0.3f), hy = rng.uniform(0.2f, std::min(1.5f, d * 0.3f));
        const float x = rng.uniform(hx + 0.3f, w - hx - 0.3f), y = rng.uniform(hy + 0.3f, d - hy - 0.3f);
        r.skylights.push_back({OpeningKind::Sky, x - hx, x + hx, y - hy, y + hy, rng.uniform(0.15f, 0.8f)});
    }
    for (size_t i = 0; i < plan.size(); ++i) {
        const int material = accent && static_cast<int>(i) == accentWall ? palette.accentWall : palette.wall;
        r.walls.push_back(makeWall(plan[i], plan[(i + 1) % plan.size()], material));
        r.walls.back().reentrant = isL && (i == 2 || i == 3);
        // At the reentrant corner of an L, the extension would stick out into the room.
        r.walls.back().endLap = isL && i == 2 ? 0 : 0.02f;
        r.walls.back().startLap = isL && i == 3 ? 0 : 0.02f;
    }
    return r;
}

ShellLight buildShell(Room& room, Draft& draft, Rng& rng, const Palette& palette, int& groups) {
    ShellLight light;
    const bool sky = rng.chance(0.6f);
    chooseOpenings(room, rng, sky);
    const Pen pen(draft, {});
    floorAndCeiling(room, pen, palette);
    for (const Room::Rect& r : room.rects) {
        draft.freeVolumes.push_back({{}, {r.x0, r.y0, 0}, {r.x1, r.y1, room.eaves + room.rise}});
    }
    for (const Wall& w : room.walls) {
        const Pen wallPen(draft, w.frame);
        perforatedWall(wallPen, w.openings, -w.startLap, w.length + w.endLap, 0, room.eaves, 0, w.material, true);
        gableEnd(room, w, wallPen);
        for (const Opening& o : w.openings) buildOpening(w, o, draft, rng, palette, light, groups);
    }
    for (const Opening& o : room.skylights) skylight(o, room.eaves, draft, palette, light);
    if (rng.chance(0.7f)) skirting(room, draft, rng, palette);
    pillarsAndBeams(room, draft, rng, palette);
    if (light.skyArea > 0) outside(room, draft, rng, palette);
    return light;
}

}  // namespace drc::interior
