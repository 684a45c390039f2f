#include "generator_fixtures.h"

#include <algorithm>

namespace drc::interior {
namespace {

// A material for fixtures, white more often than not.
int enamel(const Kit& k) { return k.rng.chance(0.7f) ? k.palette.trim : k.ornament(); }

// A tap: a vertical pipe with a spout to the front.
void tap(const Kit& k, const Vec3& at, float height) {
    const int m = k.metal();
    k.pen.rod(at, at + Vec3(0, 0, height), 0.012f, m);
    k.pen.rod(at + Vec3(0, -0.005f, height - 0.01f), at + Vec3(0, 0.13f, height - 0.03f), 0.01f, m);
}

// An open box with thick walls; light only enters from above.
void basin(const Kit& k, const Vec3& lo, const Vec3& hi, float thick, int material) {
    k.pen.box(lo, {hi.x, hi.y, lo.z + thick}, material);
    k.pen.bevelledBox({lo.x, lo.y, lo.z}, {lo.x + thick, hi.y, hi.z}, 0.01f, material);
    k.pen.bevelledBox({hi.x - thick, lo.y, lo.z}, {hi.x, hi.y, hi.z}, 0.01f, material);
    k.pen.bevelledBox({lo.x + thick, lo.y, lo.z}, {hi.x - thick, lo.y + thick, hi.z}, 0.01f, material);
    k.pen.bevelledBox({lo.x + thick, hi.y - thick, lo.z}, {hi.x - thick, hi.y, hi.z}, 0.01f, material);
}

}  // namespace

void bathtub(const Kit& k) {
    const int m = enamel(k);
    const float x = k.size.x / 2, rim = k.rng.uniform(0.04f, 0.09f);
    basin(k, {-x, 0, 0}, {x, k.size.y, k.size.z}, rim, m);
    // The inside is sloped at one end.
    k.pen.quad({-x + rim, rim, k.size.z * 0.9f}, {-x + rim + 0.3f, rim, 0.1f}, {-x + rim + 0.3f, k.size.y - rim, 0.1f},
               {-x + rim, k.size.y - rim, k.size.z * 0.9f}, m);
    tap(k, {x - rim / 2, k.size.y * 0.4f, k.size.z}, 0.15f);
}

void washbasin(const Kit& k) {
    const int m = enamel(k);
    const float r = std::min(k.size.x / 2, k.size.y / 2), z = k.size.z;
    const Vec3 c = k.middle();
    if (k.rng.chance(0.5f)) {
        k.pen.lathe(c, {{0, 0}, {r * 0.5f, 0}, {r * 0.25f, z * 0.4f}, {r * 0.3f, z - 0.15f}}, m);
    } else {
        k.pen.bevelledBox({-k.size.x / 2, 0, 0.1f}, {k.size.x / 2, k.size.y, z - 0.16f}, 0.01f, k.wood());
    }
    k.pen.lathe(c + Vec3(0, 0, z - 0.15f),
                {{0, 0},
                 {r * 0.5f, 0},
                 {r * 0.9f, 0.06f},
                 {r, 0.15f},
                 {r * 0.9f, 0.15f},
                 {r * 0.75f, 0.07f},
                 {r * 0.4f, 0.03f},
                 {0, 0.025f}},
                m, 32);
    tap(k, {0, 0.05f, z - 0.02f}, 0.16f);
    const float w = k.rng.uniform(0.2f, 0.5f), top = k.rng.uniform(1.6f, 2);
    k.pen.box({-w, -0.015f, z + 0.25f}, {w, 0.005f, top}, k.metal());
    k.pen.quad({w - 0.01f, 0.006f, z + 0.26f}, {-w + 0.01f, 0.006f, z + 0.26f}, {-w + 0.01f, 0.006f, top - 0.01f},
               {w - 0.01f, 0.006f, top - 0.01f}, k.palette.mirror, true);
}

void toilet(const Kit& k) {
    const int m = enamel(k);
    const float x = k.size.x / 2, seat = k.size.z * 0.52f;
    k.pen.bevelledBox({-x, 0, seat * 0.9f}, {x, k.size.y * 0.28f, k.size.z}, 0.02f, m);
    k.pen.cushion({-x * 0.7f, k.size.y * 0.2f, -0.1f}, {x * 0.7f, k.size.y * 0.9f, seat * 0.9f}, m, 0.6f);
    k.pen.cushion({-x, k.size.y * 0.22f, seat - 0.05f}, {x, k.size.y, seat}, m, 0.5f);
}

void showerScreen(const Kit& k) {
    const float x = k.size.x / 2, y = k.size.y, t = 0.004f;
    k.pen.bevelledBox({-x, 0, 0}, {x, y, 0.06f}, 0.01f, enamel(k));
    const size_t solids = k.pen.draft().solids.size();
    k.pen.box({-x, y - t, 0.07f}, {x, y, k.size.z}, k.rng.chance(0.7f) ? k.palette.pane : k.palette.glass);
    k.pen.draft().solids.resize(solids);  // it is transparent
    const int m = k.metal();
    k.pen.rod({0, 0.03f, 1}, {0, 0.03f, k.size.z - 0.05f}, 0.012f, m);
    k.pen.cylinder({0, 0.15f, k.size.z - 0.08f}, 0.08f, 0.02f, m);
}

void counter(const Kit& k) {
    const float x = k.size.x / 2, y = k.size.y, z = k.size.z;
    const int body = k.wood(), worktop = k.rng.chance(0.5f) ? k.palette.trim : k.ornament();
    k.pen.box({-x, 0, 0.09f}, {x, y - 0.03f, z - 0.04f}, body);
    k.pen.bevelledBox({-x, 0, z - 0.039f}, {x, y, z}, 0.005f, worktop);
    const int doors = std::max(1, static_cast<int>(k.size.x / k.rng.uniform(0.4f, 0.7f)));
    const float pitch = k.size.x / static_cast<float>(doors);
    const int front = k.rng.chance(0.5f) ? body : k.wood(), handle = k.metal();
    for (int i = 0; i < doors; ++i) {
        const float x0 = -x + pitch * static_cast<float>(i) + 0.004f, x1 = x0 + pitch - 0.008f;
        k.pen.bevelledBox({x0, y - 0.029f, 0.1f}, {x1, y - 0.012f, z - 0.05f}, 0.004f, front);
        k.pen.rod({x1 - 0.05f, y - 0.002f, z * 0.6f}, {x1 - 0.05f, y - 0.002f, z * 0.8f}, 0.006f, handle);
    }
    k.pen.surface({0, y / 2, z}, x - 0.08f, y / 2 - 0.08f, 0.45f);
    if (k.rng.chance(0.6f)) {  // cupboards above, which shade the worktop
        const float lo = z + k.rng.uniform(0.5f, 0.65f), hi = lo + k.rng.uniform(0.3f, 0.6f);
        k.pen.bevelledBox({-x, 0, lo}, {x, y * 0.55f, hi}, 0.004f, front);
    } else {
        tap(k, {0, 0.08f, z}, 0.25f);
    }
}

void hood(const Kit& k) {
    const float x = k.size.x / 2, y = k.size.y, z = k.size.z * 0.55f;
    const int m = k.metal();
    k.pen.box({-x, 0, 0}, {x, y, z}, k.wood());
    for (const float sx : {-0.5f, 0.5f}) {
        for (const float sy : {0.3f, 0.7f}) k.pen.cylinder({sx * x, sy * y, z}, 0.09f, 0.006f, k.metal());
    }
    const float lo = z + 0.6f;
    k.pen.box({-x, 0, lo}, {x, y * 0.8f, lo + 0.06f}, m);
    k.pen.box({-x * 0.35f, 0, lo + 0.061f}, {x * 0.35f, y * 0.35f, std::max(lo + 0.1f, k.size.z)}, m);
}

void rack(const Kit& k) {
    const float x = k.size.x / 2 - 0.02f, y0 = 0.02f, y1 = k.size.y - 0.02f, r = k.rng.uniform(0.004f, 0.012f);
    const int m = k.metal();
    for (const float sx : {-x, x}) {
        for (const float y : {y0, y1}) k.pen.rod({sx, y, 0}, {sx, y, k.size.z}, r * 1.5f, m);
    }
    const int shelves = k.rng.integer(2, 5), wires = k.rng.integer(3, 9);
    for (int i = 0; i < shelves; ++i) {
        const float z = k.size.z * (static_cast<float>(i) + 0.5f) / static_cast<float>(shelves);
        for (int j = 0; j < wires; ++j) {
            const float y = lerp(static_cast<float>(j) / static_cast<float>(wires - 1), y0, y1);
            k.pen.rod({-x, y, z}, {x, y, z}, r * 0.6f, m);
        }
        k.pen.surface({0, k.size.y / 2, z + r}, x - 0.05f, k.size.y / 2 - 0.05f,
                      k.size.z / static_cast<float>(shelves) - 0.05f);
    }
}

}  // namespace drc::interior
