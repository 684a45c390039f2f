#include "generator_furniture.h"

#include <algorithm>
#include <string>

#include "generator_fixtures.h"
#include "generator_piece.h"
#include "generator_shapes.h"

namespace drc::interior {
namespace {

void legs(const Kit& k, float height, float inset, int material) {
    const float x = k.size.x / 2 - inset, t = k.rng.uniform(0.015f, 0.045f);
    const bool round = k.rng.chance(0.4f);
    for (const float sx : {-x, x}) {
        for (const float y : {inset, k.size.y - inset}) {
            if (round) {
                k.pen.cylinder({sx, y, 0}, t, height, material, 12);
            } else {
                k.pen.box({sx - t, y - t, 0}, {sx + t, y + t, height}, material);
            }
        }
    }
}

void top(const Kit& k, float thickness, int material, float clearance) {
    k.pen.bevelledBox({-k.size.x / 2, 0, k.size.z - thickness}, {k.size.x / 2, k.size.y, k.size.z}, 0.006f, material);
    k.pen.surface({0, k.size.y / 2, k.size.z}, k.size.x / 2 - 0.06f, k.size.y / 2 - 0.06f, clearance);
}

void table(const Kit& k) {
    const int m = k.wood();
    const float thickness = k.rng.uniform(0.02f, 0.06f);
    legs(k, k.size.z - thickness, 0.08f, k.rng.chance(0.6f) ? m : k.metal());
    top(k, thickness, k.rng.chance(0.08f) ? k.palette.glass : m, 0.6f);
}

void roundTable(const Kit& k) {
    const float r = std::min(k.size.x, k.size.y) / 2;
    const Vec3 c(0, k.size.y / 2, 0);
    const int m = k.wood();
    k.pen.cylinder(c, r * 0.5f, 0.03f, m);
    k.pen.cylinder(c + Vec3(0, 0, 0.03f), 0.04f, k.size.z - 0.06f, k.metal(), 16);
    k.pen.cylinder(c + Vec3(0, 0, k.size.z - 0.03f), r, 0.03f, m, 40);
    k.pen.surface(c + Vec3(0, 0, k.size.z), r * 0.6f, r * 0.6f, 0.5f);
}

void chair(const Kit& k) {
    const int m = k.wood();
    const float seat = k.size.z * 0.5f;
    legs(k, seat - 0.03f, 0.05f, m);
    k.pen.bevelledBox({-k.size.x / 2, 0, seat - 0.03f}, {k.size.x / 2, k.size.y, seat}, 0.01f,
                      k.rng.chance(0.5f) ? m : k.cloth());
    const int slats = k.rng.integer(0, 5);
    if (slats == 0) {
        k.pen.bevelledBox({-k.size.x / 2, 0, seat}, {k.size.x / 2, 0.035f, k.size.z}, 0.01f, m);
        return;
    }
    for (const float s : {-1.f, 1.f})
        k.pen.rod({s * (k.size.x / 2 - 0.02f), 0.02f, seat}, {s * (k.size.x / 2 - 0.02f), 0.02f, k.size.z}, 0.017f, m);
    for (int i = 0; i < slats; ++i) {
        const float z = lerp((static_cast<float>(i) + 0.7f) / static_cast<float>(slats), seat, k.size.z - 0.06f);
        k.pen.box({-k.size.x / 2 + 0.02f, 0.01f, z}, {k.size.x / 2 - 0.02f, 0.03f, z + 0.04f}, m);
    }
}

void books(const Kit& k, float x0, float x1, float y0, float y1, float z, float room) {
    float x = x0;
    while (x < x1 - 0.06f) {
        if (k.rng.chance(0.12f)) {
            x += k.rng.uniform(0.05f, 0.25f);
            continue;
        }
        const float w = k.rng.uniform(0.012f, 0.05f), h = room * k.rng.uniform(0.6f, 0.93f),
                    d = (y1 - y0) * k.rng.uniform(0.6f, 0.95f);
        k.pen.box({x, y0, z}, {x + w, y0 + d, z + h}, k.rng.pick(k.palette.paper));
        x += w + 0.001f;
    }
}

void shelf(const Kit& k) {
    const int m = k.wood();
    const float w = k.size.x / 2, d = k.size.y, t = k.rng.uniform(0.015f, 0.03f);
    k.pen.box({-w, 0, 0}, {-w + t, d, k.size.z}, m);
    k.pen.box({w - t, 0, 0}, {w, d, k.size.z}, m);
    if (k.rng.chance(0.7f)) k.pen.box({-w + t, 0, 0}, {w - t, 0.01f, k.size.z}, m);
    const int levels = std::max(2, static_cast<int>(k.size.z / k.rng.uniform(0.28f, 0.45f)));
    const float pitch = (k.size.z - t) / static_cast<float>(levels);
    for (int i = 0; i <= levels; ++i) {
        const float z = pitch * static_cast<float>(i);
        k.pen.box({-w + t, 0, z}, {w - t, d, z + t}, m);
        if (i == levels) continue;
        if (k.rng.chance(0.65f)) {
            books(k, -w + t + 0.01f, w - t, 0.02f, d, z + t, pitch - t);
        } else {
            k.pen.surface({0, d / 2, z + t}, w - 0.06f, d / 2 - 0.03f, pitch - t - 0.04f);
        }
    }
    k.pen.surface({0, d / 2, k.size.z + t * 0.01f}, w - 0.05f, d / 2 - 0.03f, 0.3f);
}

void sofa(const Kit& k) {
    const int m = k.cloth();
    const float w = k.size.x / 2, d = k.size.y, arm = k.rng.uniform(0.1f, 0.22f), seat = k.rng.uniform(0.36f, 0.46f);
    k.pen.bevelledBox({-w, 0, 0.06f}, {w, d, seat - 0.12f}, 0.03f, m);
    k.pen.bevelledBox({-w, 0, 0.05f}, {w, 0.2f, k.size.z}, 0.06f, m);
    for (const float s : {-1.f, 1.f}) {
        const float a = s < 0 ? -w : w - arm;
        k.pen.bevelledBox({a, 0.02f, 0.05f}, {a + arm, d, seat + 0.18f}, 0.05f, m);
        k.pen.box({s * (w - 0.1f) - 0.03f, 0.05f, 0}, {s * (w - 0.1f) + 0.03f, 0.11f, 0.06f},
                  k.palette.furniture.front());
        k.pen.box({s * (w - 0.1f) - 0.03f, d - 0.11f, 0}, {s * (w - 0.1f) + 0.03f, d - 0.05f, 0.06f},
                  k.palette.furniture.front());
    }
    const int seats = std::max(1, static_cast<int>(std::lround((2 * w - 2 * arm) / 0.7f)));
    const float pitch = (2 * w - 2 * arm) / static_cast<float>(seats);
    for (int i = 0; i < seats; ++i) {
        const float x = -w + arm + pitch * static_cast<float>(i);
        k.pen.cushion({x, 0.18f, seat - 0.14f}, {x + pitch, d + 0.02f, seat + 0.03f}, m, 0.3f);
        if (k.rng.chance(0.6f))
            k.pen.inner({x + pitch / 2, 0.26f, 0}, k.rng.uniform(-0.4f, 0.4f))
                .cushion({-0.2f, -0.06f, seat}, {0.2f, 0.08f, seat + 0.36f}, k.cloth(), 0.55f);
    }
}

void bed(const Kit& k) {
    const float w = k.size.x / 2, d = k.size.y;
    k.pen.bevelledBox({-w, 0, 0.1f}, {w, d, 0.3f}, 0.02f, k.wood());
    k.pen.bevelledBox({-w, -0.0f, 0.05f}, {w, 0.06f, k.size.z}, 0.02f, k.wood());
    k.pen.cushion({-w + 0.02f, 0.06f, 0.25f}, {w - 0.02f, d, 0.55f}, k.cloth(), 0.2f);
    k.pen.cushion({-w - 0.01f, 0.7f, 0.24f}, {w + 0.01f, d + 0.02f, 0.58f}, k.cloth(), 0.2f);
    const int pillows = w > 0.6f ? 2 : 1;
    for (int i = 0; i < pillows; ++i) {
        const float x = pillows == 1 ? 0 : (i == 0 ? -w / 2 : w / 2);
        k.pen.cushion({x - 0.3f, 0.1f, 0.53f}, {x + 0.3f, 0.5f, 0.7f}, k.cloth(), 0.5f);
    }
}

void cabinet(const Kit& k) {
    const int m = k.wood();
    const float w = k.size.x / 2, d = k.size.y;
    k.pen.bevelledBox({-w, 0, 0.05f}, {w, d - 0.02f, k.size.z}, 0.004f, m);
    k.pen.box({-w + 0.04f, 0, 0}, {w - 0.04f, d - 0.06f, 0.05f}, k.palette.furniture.front());
    const int columns = std::max(1, static_cast<int>(std::lround(k.size.x / k.rng.uniform(0.4f, 0.6f))));
    const int rows = std::max(1, static_cast<int>(std::lround(k.size.z / k.rng.uniform(0.25f, 1.2f))));
    const int front = k.rng.chance(0.7f) ? m : k.wood();
    const int knob = k.metal();
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const float x0 = -w + k.size.x * static_cast<float>(i) / static_cast<float>(columns) + 0.01f;
            const float x1 = x0 + k.size.x / static_cast<float>(columns) - 0.02f;
            const float z0 = 0.06f + (k.size.z - 0.07f) * static_cast<float>(j) / static_cast<float>(rows) + 0.005f;
            const float z1 = z0 + (k.size.z - 0.07f) / static_cast<float>(rows) - 0.01f;
            k.pen.bevelledBox({x0, d - 0.02f, z0}, {x1, d - 0.002f, z1}, 0.004f, front);
            k.pen.box({(x0 + x1) / 2 - 0.04f, d - 0.002f, z1 - 0.07f}, {(x0 + x1) / 2 + 0.04f, d + 0.015f, z1 - 0.058f},
                      knob);
        }
    }
    if (k.size.z < 1.4f) k.pen.surface({0, d / 2, k.size.z}, w - 0.06f, d / 2 - 0.06f, 0.6f);
}

void steps(const Kit& k) {
    const int count = std::max(3, static_cast<int>(k.size.z / 0.18f));
    const int m = k.rng.chance(0.5f) ? k.wood() : k.palette.wall;
    const bool open = k.rng.chance(0.4f);
    const float rise = k.size.z / static_cast<float>(count), run = k.size.x / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const float x = -k.size.x / 2 + run * static_cast<float>(i), z = rise * static_cast<float>(i + 1);
        k.pen.box({x, 0, open ? z - 0.05f : 0}, {x + run, k.size.y, z}, m);
    }
    if (!k.rng.chance(0.6f)) return;
    const int metal = k.metal();
    for (int i = 0; i < count; ++i) {
        const float x = -k.size.x / 2 + run * (static_cast<float>(i) + 0.5f), z = rise * static_cast<float>(i + 1);
        k.pen.rod({x, k.size.y - 0.04f, z}, {x, k.size.y - 0.04f, z + 0.85f}, 0.008f, metal);
    }
    k.pen.rod({-k.size.x / 2 + run / 2, k.size.y - 0.04f, rise + 0.85f},
              {k.size.x / 2 - run / 2, k.size.y - 0.04f, k.size.z + 0.85f}, 0.02f, metal);
}

void plant(const Kit& k) {
    const float pot = k.size.x * 0.28f, potHeight = k.size.z * k.rng.uniform(0.2f, 0.35f);
    const Vec3 c(0, k.size.y / 2, 0);
    k.pen.lathe(c,
                {{0, 0},
                 {pot * 0.7f, 0},
                 {pot, potHeight},
                 {pot * 0.9f, potHeight},
                 {pot * 0.85f, potHeight * 0.9f},
                 {0, potHeight * 0.9f}},
                k.rng.pick(k.palette.ornament));
    const int stems = k.rng.integer(3, 9);
    for (int s = 0; s < stems; ++s) {
        const float phi = k.rng.uniform(0, 2 * kPi), reach = k.size.x * 0.35f * k.rng.uniform(0.2f, 1);
        const Vec3 root = c + Vec3(0, 0, potHeight * 0.85f);
        const Vec3 tip = c + Vec3(reach * std::cos(phi), reach * std::sin(phi), k.size.z * k.rng.uniform(0.7f, 1));
        k.pen.rod(root, tip, 0.006f, k.palette.stem);
        const int leaves = k.rng.integer(5, 14);
        for (int i = 0; i < leaves; ++i) {
            const Vec3 at = root + (tip - root) * k.rng.uniform(0.35f, 1);
            const float turn = k.rng.uniform(0, 2 * kPi), length = k.rng.uniform(0.1f, 0.28f),
                        tilt = k.rng.uniform(-0.5f, 0.7f);
            const Vec3 along(std::cos(turn) * length, std::sin(turn) * length, tilt * length);
            const Vec3 across(-std::sin(turn) * length * 0.3f, std::cos(turn) * length * 0.3f,
                              k.rng.uniform(-0.03f, 0.03f));
            k.pen.quad(at - across, at + across, at + along + across, at + along - across, k.palette.leaf, true);
        }
    }
}

void stool(const Kit& k) {
    const Vec3 c(0, k.size.y / 2, 0);
    if (k.rng.chance(0.5f)) {
        k.pen.cylinder(c, k.size.x * 0.48f, k.size.z, k.cloth(), 32);
    } else {
        k.pen.cushion({-k.size.x / 2, 0, -k.size.z * 0.1f}, {k.size.x / 2, k.size.y, k.size.z}, k.cloth(), 0.7f);
    }
}

void crates(const Kit& k) {
    float z = 0;
    while (z < k.size.z - 0.1f) {
        const float s = k.size.x * k.rng.uniform(0.6f, 1) / 2, h = std::min(k.rng.uniform(0.15f, 0.5f), k.size.z - z);
        k.pen.inner({0, k.size.y / 2, 0}, k.rng.uniform(-0.2f, 0.2f))
            .box({-s, -s * 0.9f, z}, {s, s * 0.9f, z + h}, k.wood());
        z += h + 0.001f;
    }
}

void screen(const Kit& k) {
    const int m = k.cloth();
    const int folds = k.rng.integer(3, 5);
    const float pitch = k.size.x / static_cast<float>(folds);
    for (int i = 0; i < folds; ++i) {
        const float x = -k.size.x / 2 + pitch * static_cast<float>(i);
        const float y0 = i % 2 == 0 ? 0.02f : k.size.y - 0.04f, y1 = i % 2 == 0 ? k.size.y - 0.04f : 0.02f;
        const float turn = std::atan2(y1 - y0, pitch);
        k.pen.inner({x, y0, 0}, turn).box({0, -0.01f, 0.02f}, {pitch / std::cos(turn) - 0.005f, 0.01f, k.size.z}, m);
    }
}

void radiator(const Kit& k) {
    const int m = k.palette.trim;
    for (float x = -k.size.x / 2; x < k.size.x / 2 - 0.05f; x += 0.06f)
        k.pen.bevelledBox({x, 0.03f, 0.12f}, {x + 0.045f, k.size.y, k.size.z}, 0.01f, m);
    for (const float z : {0.18f, k.size.z - 0.06f})
        k.pen.rod({-k.size.x / 2, k.size.y / 2, z}, {k.size.x / 2 - 0.04f, k.size.y / 2, z}, 0.015f, m);
}

void beanbag(const Kit& k) { drawSubdivided(k.pen, k.middle(), k.size.x, k.size.z, k.rng, k.cloth()); }

void quadricStand(const Kit& k) {
    drawQuadric(k.pen, k.middle(), k.size.x, k.size.z, k.rng, k.rng.chance(0.5f) ? k.wood() : k.ornament());
}

void grass(const Kit& k) {
    const float pot = k.size.z * k.rng.uniform(0.15f, 0.4f);
    k.pen.cylinder(k.middle(), k.size.x * 0.25f, pot, k.ornament());
    drawTuft(k.pen, k.middle() + Vec3(0, 0, pot), k.size.x * 0.5f, k.size.z - pot, k.rng.integer(15, 90), k.rng,
             k.palette.leaf);
}

const std::vector<Piece> kPieces = {
    // smallest and largest size; whether it stands at a wall; weights in living rooms, corridors, bathrooms, kitchens,
    // halls
    {table, {0.6f, 0.5f, 0.35f}, {2.0f, 1.0f, 0.95f}, false, {3, 0, 0.3f, 3, 4}},
    {roundTable, {0.5f, 0.5f, 0.4f}, {1.3f, 1.3f, 0.8f}, false, {1.5f, 0.2f, 0.2f, 1.5f, 2}},
    {chair, {0.38f, 0.38f, 0.75f}, {0.55f, 0.5f, 1.1f}, false, {4, 1, 0.5f, 5, 6}},
    {shelf, {0.6f, 0.2f, 0.7f}, {2.2f, 0.4f, 2.3f}, true, {3, 2, 1, 1, 3}},
    {sofa, {1.0f, 0.75f, 0.65f}, {2.4f, 1.0f, 0.95f}, true, {2, 0, 0, 0.2f, 2}},
    {bed, {0.9f, 1.8f, 0.7f}, {1.8f, 2.1f, 1.2f}, true, {1, 0, 0, 0, 0.2f}},
    {cabinet, {0.4f, 0.35f, 0.4f}, {2.2f, 0.65f, 2.3f}, true, {3, 2, 2, 2, 2}},
    {steps, {0.9f, 0.6f, 0.5f}, {3.2f, 1.1f, 2.2f}, true, {1, 1, 0, 0, 3}},
    {plant, {0.4f, 0.4f, 0.5f}, {0.9f, 0.9f, 1.8f}, false, {2, 1, 0.7f, 0.7f, 2}},
    {stool, {0.3f, 0.3f, 0.3f}, {0.8f, 0.8f, 0.5f}, false, {1.5f, 0.5f, 1, 1, 1}},
    {crates, {0.25f, 0.25f, 0.2f}, {0.8f, 0.8f, 1.6f}, false, {1.5f, 1.5f, 0.3f, 0.7f, 2}},
    {screen, {1.0f, 0.3f, 1.2f}, {2.0f, 0.5f, 1.9f}, false, {0.7f, 0, 0.3f, 0, 0.7f}},
    {radiator, {0.5f, 0.12f, 0.4f}, {1.6f, 0.18f, 0.8f}, true, {1, 1.5f, 1, 0.7f, 0.5f}},
    {beanbag, {0.5f, 0.5f, 0.35f}, {1.1f, 1.1f, 0.9f}, false, {1, 0.3f, 0.2f, 0.2f, 1}},
    {quadricStand, {0.25f, 0.25f, 0.3f}, {0.8f, 0.8f, 1.2f}, false, {1, 0.5f, 0.5f, 0.5f, 1}},
    {grass, {0.3f, 0.3f, 0.4f}, {0.9f, 0.9f, 1.6f}, false, {0.8f, 0.5f, 0.3f, 0.3f, 0.8f}},
    {bathtub, {1.3f, 0.65f, 0.45f}, {1.9f, 0.85f, 0.65f}, true, {0, 0, 4, 0, 0}},
    {washbasin, {0.45f, 0.38f, 0.8f}, {0.8f, 0.5f, 0.92f}, true, {0, 0.3f, 4, 0.3f, 0}},
    {toilet, {0.35f, 0.6f, 0.7f}, {0.4f, 0.7f, 0.85f}, true, {0, 0, 3, 0, 0}},
    {showerScreen, {0.8f, 0.8f, 1.9f}, {1.2f, 1.1f, 2.1f}, true, {0, 0, 2.5f, 0, 0}},
    {counter, {0.6f, 0.55f, 0.85f}, {3.0f, 0.7f, 0.95f}, true, {0.3f, 0, 0.5f, 8, 0.3f}},
    {hood, {0.55f, 0.55f, 1.9f}, {0.8f, 0.65f, 2.3f}, true, {0, 0, 0, 3, 0}},
    {rack, {0.5f, 0.25f, 0.7f}, {1.4f, 0.5f, 1.9f}, true, {0.5f, 0.7f, 1, 1.5f, 0.7f}},
};

bool fits(const Room& room, const Draft& draft, const OrientedBox& box) {
    const Vec3 lo = box.worldLo(), hi = box.worldHi();
    // The room is rectilinear: tests the corners, and the edges' midpoints for the notch of an L.
    for (const float x : {lo.x, (lo.x + hi.x) / 2, hi.x}) {
        for (const float y : {lo.y, (lo.y + hi.y) / 2, hi.y}) {
            if (!room.contains(x, y, 0.005f)) return false;
        }
    }
    return std::none_of(draft.footprints.begin(), draft.footprints.end(), [&](const OrientedBox& o) {
        const Vec3 l = o.worldLo(), h = o.worldHi();
        return lo.x < h.x && l.x < hi.x && lo.y < h.y && l.y < hi.y;
    });
}

bool place(Room& room, Draft& draft, Rng& rng, const Palette& palette, const Piece& piece) {
    Vec3 size;
    for (int i = 0; i < 3; ++i) size[i] = rng.uniform(piece.least[i], piece.most[i]);
    size.z = std::min(size.z, room.eaves - 0.15f);
    for (int attempt = 0; attempt < 10; ++attempt) {
        Placement frame;
        Wall* wall = nullptr;
        float u = 0;
        if (piece.atWall) {
            wall = &room.walls[static_cast<size_t>(rng.integer(0, static_cast<int>(room.walls.size()) - 1))];
            if (wall->length < size.x + 0.1f) continue;
            u = rng.uniform(size.x / 2 + 0.03f, wall->length - size.x / 2 - 0.03f);
            if (!wall->isFree({u - size.x / 2, u + size.x / 2, 0, size.z})) continue;
            frame = wall->frame.inner(Placement{{u, rng.uniform(0.025f, 0.06f), 0}, 1, 0});
        } else {
            const float turns[] = {0, kPi / 2, kPi, -kPi / 2, rng.uniform(0, 2 * kPi)};
            const Vec3 at{rng.uniform(0, room.width), rng.uniform(0, room.depth), 0};
            frame = Placement::at(at, turns[rng.integer(0, 4)]);
        }
        const OrientedBox box{frame, {-size.x / 2, 0, 0}, {size.x / 2, size.y, size.z}};
        if (!fits(room, draft, box)) continue;
        draft.footprints.push_back(box);
        if (wall) wall->uses.push_back({u - size.x / 2, u + size.x / 2, 0, size.z});
        const Pen pen(draft, frame);
        piece.build({pen, size, rng, palette});
        return true;
    }
    return false;
}

// Keeps the floor in front of doors free.
void keepDoorsClear(const Room& room, Draft& draft) {
    for (const Wall& w : room.walls) {
        for (const Opening& o : w.openings) {
            if (o.kind == OpeningKind::DoorAjar)
                draft.footprints.push_back({w.frame, {o.u0, -0.1f, 0}, {o.u1, 0.7f, 2}});
        }
    }
}

}  // namespace

void furnish(Room& room, Draft& draft, Rng& rng, const Palette& palette, RoomKind kind, float share) {
    keepDoorsClear(room, draft);
    const size_t first = draft.footprints.size();
    const float wanted = share * room.floorArea();
    float total = 0;
    for (const Piece& p : kPieces) total += p.weight[size_t(kind)];
    for (int attempt = 0; attempt < 40; ++attempt) {
        float taken = 0;
        for (size_t i = first; i < draft.footprints.size(); ++i) {
            const Vec3 d = draft.footprints[i].hi - draft.footprints[i].lo;
            taken += d.x * d.y;
        }
        if (taken > wanted || draft.triangleCount() > 30000) break;
        float x = rng.uniform(0, total);
        const Piece* chosen = &kPieces.back();
        for (const Piece& p : kPieces) {
            if ((x -= p.weight[size_t(kind)]) < 0) {
                chosen = &p;
                break;
            }
        }
        Rng own = rng.fork();
        place(room, draft, own, palette, *chosen);
    }
}

void scatterPrimitives(const Room& room, Draft& draft, Rng& rng, const Palette& palette, int count) {
    const auto anyMaterial = [&] {
        return rng.chance(0.5f)   ? rng.pick(palette.ornament)
               : rng.chance(0.5f) ? rng.pick(palette.furniture)
                                  : rng.pick(palette.fabric);
    };
    for (int i = 0; i < count; ++i) {
        const float r = rng.logUniform(0.06f, 0.5f), h = rng.logUniform(0.08f, 1.6f);
        const Vec3 at{rng.uniform(0, room.width), rng.uniform(0, room.depth), 0};
        const Placement frame = Placement::at(at, rng.uniform(0, 2 * kPi));
        const OrientedBox box{frame, {-r, -r, 0}, {r, r, h}};
        if (!fits(room, draft, box)) continue;
        const Pen pen(draft, frame);
        const int material = anyMaterial();
        // Some hover above the floor, since light below an object is a case of its own.
        const float lift =
            rng.chance(0.2f) ? rng.uniform(0.05f, std::max(0.06f, room.eaves - 2 * r - h - 0.2f)) : 0.002f;
        switch (rng.integer(0, 7)) {
            case 0:
                pen.sphere({0, 0, r + lift}, r, material);
                break;
            case 1:
                pen.cylinder({0, 0, lift}, r, h, material, 32);
                break;
            case 2:
                pen.lathe({0, 0, lift}, {{0, 0}, {r, 0}, {0, h}}, material, 32);
                break;
            case 3:
                pen.cushion({-r, -r, lift}, {r, r, lift + h}, material, rng.uniform(0.2f, 1));
                break;
            case 4:
                drawSubdivided(pen, {0, 0, lift}, 2 * r, h, rng, material);
                break;
            case 5:
                drawQuadric(pen, {0, 0, lift}, 2 * r, h, rng, material);
                break;
            case 6:
                drawTuft(pen, {0, 0, 0}, r, h, 40, rng, palette.leaf);
                break;
            default:
                pen.box({-r, -r, lift}, {r, r, lift + h}, material);
                break;
        }
        draft.footprints.push_back({frame, {-r, -r, 0}, {r, r, std::max(h, 2 * r) + lift}});
    }
}

}  // namespace drc::interior
