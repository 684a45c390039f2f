#include "generator_decor.h"

#include <algorithm>

#include "generator_shapes.h"

namespace drc::interior {
namespace {

// A small object about `size` wide and at most `room` high, standing on z = 0.
void ornament(const Pen& pen, float size, float room, Rng& rng, const Palette& palette) {
    const int m = rng.pick(palette.ornament);
    const float r = size / 2, h = std::min(room, size * rng.uniform(0.8f, 3));
    switch (rng.integer(0, 9)) {
        case 0: {  // vase
            const float waist = rng.uniform(0.3f, 0.9f), lip = rng.uniform(0.3f, 0.9f);
            std::vector<Vec2> profile{{0, 0}, {r * 0.6f, 0}};
            for (int i = 1; i <= 10; ++i) {
                const float t = static_cast<float>(i) / 10;
                const float bulge = std::sin(kPi * std::pow(t, waist));
                profile.emplace_back(r * lerp(t, 0.6f, lip * 0.6f) + r * 0.4f * bulge, h * t);
            }
            profile.emplace_back(profile.back().x * 0.85f, h);
            profile.emplace_back(profile.back().x * 0.9f, h * 0.15f);
            profile.emplace_back(0, h * 0.15f);
            pen.lathe({0, 0, 0.001f}, profile, m, 20);
            break;
        }
        case 1: {  // bowl
            std::vector<Vec2> profile{{0, 0}, {r * 0.35f, 0}};
            for (int i = 1; i <= 6; ++i) {
                const float a = kPi / 2 * static_cast<float>(i) / 6;
                profile.emplace_back(r * (0.35f + 0.65f * std::sin(a)), r * 0.7f * (1 - std::cos(a)));
            }
            for (int i = 6; i >= 0; --i) {
                const float a = kPi / 2 * static_cast<float>(i) / 6;
                profile.emplace_back(r * (0.3f + 0.65f * std::sin(a)) * (i == 0 ? 0 : 1),
                                     r * 0.04f + r * 0.66f * (1 - std::cos(a)));
            }
            pen.lathe({0, 0, 0.001f}, profile, m, 20);
            break;
        }
        case 2: {
            const float s = std::min(r, room / 2);
            pen.sphere({0, 0, s + 0.001f}, s, m);
            break;
        }
        case 3:
            pen.bevelledBox({-r, -r * 0.7f, 0.001f}, {r, r * 0.7f, h * 0.5f}, r * 0.1f, m);
            break;
        case 4: {  // a stack of books
            float z = 0.001f;
            for (int i = rng.integer(1, 5); i > 0; --i) {
                const float t = rng.uniform(0.015f, 0.04f);
                if (z + t > room) break;
                pen.inner({0, 0, 0}, rng.uniform(-0.4f, 0.4f))
                    .box({-r, -r * 0.75f, z}, {r, r * 0.75f, z + t}, rng.pick(palette.paper));
                z += t + 0.0005f;
            }
            break;
        }
        case 5: {  // a small frame, leaning back
            pen.box({-r, -0.01f, 0.001f}, {r, 0.01f, std::min(room, size * 1.3f)}, rng.pick(palette.furniture));
            break;
        }
        case 6:
            drawSubdivided(pen, {0, 0, 0.001f}, size, h, rng, m);
            break;
        case 7:
            drawQuadric(pen, {0, 0, 0.001f}, size, h, rng, m);
            break;
        case 8:
            drawTuft(pen, {0, 0, 0}, r, h, rng.integer(5, 25), rng, palette.leaf);
            break;
        default:
            pen.cylinder({0, 0, 0.001f}, r * 0.6f, h, m, 24);
            break;
    }
}

void picture(const Room& room, Wall& wall, Draft& draft, Rng& rng, const Palette& palette) {
    const float w = rng.uniform(0.2f, 1.4f), h = rng.uniform(0.2f, 1.1f);
    const float z0 = rng.uniform(0.9f, 1.5f), z1 = z0 + h;
    if (z1 > room.eaves - 0.1f) return;
    const auto u = wall.reserve(rng, w, z0, z1, 0.06f);
    if (!u) return;
    const Pen pen(draft, wall.frame);
    const float rim = rng.uniform(0.01f, 0.07f), depth = rng.uniform(0.01f, 0.05f);
    const int frame = rng.chance(0.3f) ? rng.pick(palette.metal) : rng.pick(palette.furniture);
    pen.box({*u, 0.001f, z0}, {*u + w, depth, z0 + rim}, frame);
    pen.box({*u, 0.001f, z1 - rim}, {*u + w, depth, z1}, frame);
    pen.box({*u, 0.001f, z0 + rim}, {*u + rim, depth, z1 - rim}, frame);
    pen.box({*u + w - rim, 0.001f, z0 + rim}, {*u + w, depth, z1 - rim}, frame);
    const int face = rng.chance(0.22f) ? palette.mirror : makePainting(draft, rng);
    const float y = depth * 0.4f;
    pen.quad({*u + w - rim, y, z0 + rim}, {*u + rim, y, z0 + rim}, {*u + rim, y, z1 - rim}, {*u + w - rim, y, z1 - rim},
             face, true);
}

void wallShelf(const Room& room, Wall& wall, Draft& draft, Rng& rng, const Palette& palette) {
    const float w = rng.uniform(0.4f, 1.6f), z = rng.uniform(1, 1.9f), d = rng.uniform(0.15f, 0.3f);
    if (z + 0.4f > room.eaves) return;
    const auto u = wall.reserve(rng, w, z - 0.05f, z + 0.35f, 0.05f);
    if (!u) return;
    const Pen pen(draft, wall.frame);
    pen.bevelledBox({*u, 0.001f, z - 0.03f}, {*u + w, d, z}, 0.003f, rng.pick(palette.furniture));
    pen.surface({*u + w / 2, d / 2, z}, w / 2 - 0.05f, d / 2 - 0.02f, 0.3f);
}

// Light shelves: boards across the upper part of windows, inside and outside, that reflect daylight to the ceiling.
void lightShelves(const Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    const float out = rng.uniform(0.2f, 0.5f), in = rng.uniform(0.15f, 0.5f), at = rng.uniform(0.55f, 0.8f);
    const int top = rng.chance(0.4f) ? palette.metal.front() : palette.trim;
    for (const Wall& w : room.walls) {
        for (const Opening& o : w.openings) {
            if (o.kind != OpeningKind::Sky || o.z1 < 1.4f) continue;
            const Pen pen(draft, w.frame);
            const float z = std::max(1.2f, lerp(at, o.z0, o.z1));
            if (z > o.z1 - 0.1f) continue;
            pen.box({o.u0 + 0.005f, -o.depth - out, z}, {o.u1 - 0.005f, -o.depth * 0.6f, z + 0.02f}, top);
            pen.box({o.u0 + 0.005f, -o.depth * 0.4f, z}, {o.u1 - 0.005f, in, z + 0.02f}, top);
        }
    }
}

}  // namespace

void placeOrnaments(Draft& draft, Rng& rng, const Palette& palette, float density) {
    const std::vector<Surface> surfaces = draft.surfaces;
    for (const Surface& s : surfaces) {
        const float w = s.hi.x - s.lo.x, d = s.hi.y - s.lo.y;
        if (w < 0.05f || d < 0.04f) continue;
        std::vector<Vec3> taken;  // occupied places: x, y, radius
        const int count = static_cast<int>(density * rng.uniform(0, 10) * std::min(1.2f, w * std::max(d, 0.3f) * 2));
        for (int i = 0; i < count && draft.triangleCount() < 38000; ++i) {
            const float size = std::min({rng.logUniform(0.06f, 0.35f), d, w});
            const Vec3 at{rng.uniform(s.lo.x, s.hi.x), rng.uniform(s.lo.y, s.hi.y), size / 2};
            const bool clash = std::any_of(taken.begin(), taken.end(), [&](const Vec3& o) {
                return sqr(o.x - at.x) + sqr(o.y - at.y) < sqr(o.z + at.z + 0.01f);
            });
            if (clash) continue;
            taken.push_back(at);
            Rng own = rng.fork();
            ornament(Pen(draft, s.frame).inner({at.x, at.y, 0}, own.uniform(0, 6)), size, s.clearance, own, palette);
        }
    }
}

void decorateWalls(Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    for (int i = rng.integer(0, 5); i > 0; --i) {
        Wall& w = room.walls[static_cast<size_t>(rng.integer(0, static_cast<int>(room.walls.size()) - 1))];
        picture(room, w, draft, rng, palette);
    }
    for (int i = rng.integer(0, 2); i > 0; --i) {
        wallShelf(room, room.walls[static_cast<size_t>(rng.integer(0, static_cast<int>(room.walls.size()) - 1))], draft,
                  rng, palette);
    }
}

void dressWindows(const Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    if (rng.chance(0.12f)) return lightShelves(room, draft, rng, palette);
    const int style = rng.integer(0, 4);
    if (style < 2) return;
    const int cloth = rng.chance(0.5f) ? rng.pick(palette.fabric) : palette.shade.front();
    for (const Wall& w : room.walls) {
        for (const Opening& o : w.openings) {
            if (o.kind != OpeningKind::Sky && o.kind != OpeningKind::LightPanel) continue;
            const Pen pen(draft, w.frame);
            if (style == 2) {  // blinds
                const float tilt = rng.uniform(0.1f, 1.2f), pitch = rng.uniform(0.04f, 0.09f),
                            bottom = lerp(rng.uniform(0, 0.7f), o.z0, o.z1);
                for (float z = o.z1 - 0.04f; z > bottom + 0.03f; z -= pitch) {
                    const float dy = 0.02f * std::cos(tilt), dz = 0.02f * std::sin(tilt);
                    pen.quad({o.u0 + 0.01f, -0.03f - dy, z - dz}, {o.u1 - 0.01f, -0.03f - dy, z - dz},
                             {o.u1 - 0.01f, -0.03f + dy, z + dz}, {o.u0 + 0.01f, -0.03f + dy, z + dz}, palette.trim);
                }
                continue;
            }
            // Curtains. The rod needs room above the window. No furniture is that close to the wall.
            const float top = std::min(o.z1 + 0.12f, room.eaves - 0.02f), y = 0.13f;
            const float cover = rng.uniform(0.1f, 0.48f) * (o.u1 - o.u0);
            const float left = std::max(0.03f, o.u0 - 0.15f), right = std::min(w.length - 0.03f, o.u1 + 0.15f);
            const float length = style == 3 ? top - 0.03f : top - o.z0 + 0.1f;
            pen.rod({left, y, top}, {right, y, top}, 0.012f, palette.metal.front());
            const int folds = std::max(3, static_cast<int>((cover + 0.15f) / 0.09f));
            pen.curtain({left, y, top}, {o.u0 + cover, y, top}, length, 0.03f, folds, cloth);
            if (rng.chance(0.8f)) pen.curtain({o.u1 - cover, y, top}, {right, y, top}, length, 0.03f, folds, cloth);
        }
    }
}

void layRug(const Room& room, Draft& draft, Rng& rng, const Palette& palette) {
    const float w = rng.uniform(0.6f, 1.4f), d = rng.uniform(0.4f, 1);
    const Vec3 c{rng.uniform(0.2f, 0.8f) * room.width, rng.uniform(0.2f, 0.8f) * room.depth, 0};
    if (!room.contains(c.x, c.y, std::max(w, d) + 0.05f)) return;
    const size_t solids = draft.solids.size();
    Pen(draft, Placement::at(c, rng.chance(0.7f) ? 0 : rng.uniform(0, 3)))
        .box({-w, -d, 0.0005f}, {w, d, 0.008f}, rng.pick(palette.fabric));
    draft.solids.resize(solids);
}

}  // namespace drc::interior
