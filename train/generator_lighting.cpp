#include "generator_lighting.h"

#include <algorithm>

namespace drc::interior {
namespace {

struct Kit {
    const Room& room;
    Draft& draft;
    Rng& rng;
    const Palette& palette;
    int group;
};

bool isClear(const Draft& draft, const Vec3& p) { return draft.inFreeSpace(p); }

float lampHeight(const Room& room, float x) {
    return room.ceiling == CeilingKind::Flat ? room.eaves : room.ceilingAt(x) - 0.02f;
}

template <typename Place>
void onGrid(const Kit& k, float margin, Place place) {
    const int nx = k.rng.integer(1, 3), ny = k.rng.integer(1, 3);
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) {
            const float x = k.room.width * (static_cast<float>(i) + 0.5f) / static_cast<float>(nx);
            const float y = k.room.depth * (static_cast<float>(j) + 0.5f) / static_cast<float>(ny);
            if (k.room.contains(x, y, margin)) place(x, y);
        }
    }
}

void ceilingPanels(const Kit& k) {
    const float hx = k.rng.uniform(0.08f, 0.7f), hy = k.rng.uniform(0.08f, 0.5f);
    const bool sloped = k.room.ceiling != CeilingKind::Flat;
    onGrid(k, std::max(hx, hy) + 0.1f, [&](float x, float y) {
        // Below a sloped ceiling, panels hang horizontally on wires.
        const float z = sloped ? std::min(k.room.ceilingAt(x - hx), k.room.ceilingAt(x + hx)) - 0.15f : k.room.eaves;
        if (!isClear(k.draft, {x, y, z - 0.08f})) return;
        const Pen pen(k.draft, {});
        pen.box({x - hx - 0.02f, y - hy - 0.02f, z - 0.05f}, {x + hx + 0.02f, y + hy + 0.02f, z - 0.001f},
                k.palette.trim);
        pen.quadLight({x, y, z - 0.052f}, {0, hy, 0}, {hx, 0, 0}, k.group, k.palette.lightBody);
    });
}

void downlights(const Kit& k) {
    const float r = k.rng.uniform(0.04f, 0.15f);
    onGrid(k, 0.2f, [&](float x, float y) {
        const float z = k.room.ceiling == CeilingKind::Flat
                            ? k.room.eaves
                            : std::min(k.room.ceilingAt(x - r), k.room.ceilingAt(x + r)) - 0.06f;
        if (!isClear(k.draft, {x, y, z - 0.06f})) return;
        const Pen pen(k.draft, {});
        pen.cylinder({x, y, z - 0.03f}, r + 0.01f, 0.029f, k.palette.metal.front(), 24);
        pen.diskLight({x, y, z - 0.032f}, {0, 0, -1}, r, k.group, k.palette.lightBody);
    });
}

// Recessed spotlights: a small bright disk deep in a can. It directly lights only a patch below, so the room is mostly
// lit indirectly.
void spots(const Kit& k) {
    const float r = k.rng.uniform(0.03f, 0.08f), depth = r * k.rng.uniform(1.5f, 5), drop = k.rng.uniform(0, 0.8f);
    const int can = k.palette.metal.front();
    for (int i = k.rng.integer(1, 3); i > 0; --i) {
        const float x = k.room.width * k.rng.uniform(0.15f, 0.85f), y = k.room.depth * k.rng.uniform(0.15f, 0.85f);
        const float top = lampHeight(k.room, x) - 0.03f - drop;
        if (!k.room.contains(x, y, 0.2f) || !isClear(k.draft, {x, y, top}) || !isClear(k.draft, {x, y, top - depth}))
            continue;
        const Pen pen(k.draft, Placement::at({x, y, 0}, 0));
        pen.cylinder({0, 0, top - 0.01f}, r * 1.05f, 0.01f, can, 24);
        pen.shade({0, 0, top - depth}, r * 1.05f, r * 1.05f, depth - 0.01f, can);
        pen.diskLight({0, 0, top - 0.012f}, {0, 0, -1}, r, k.group, k.palette.lightBody);
    }
}

void pendant(const Kit& k) {
    const int style = k.rng.integer(0, 2);
    const int shadeMaterial = k.rng.pick(k.palette.shade);
    const float drop = k.rng.uniform(0.25f, std::max(0.3f, k.room.eaves - 1.8f)), r = k.rng.uniform(0.03f, 0.16f);
    onGrid(k, 0.4f, [&](float x, float y) {
        const float top = lampHeight(k.room, x), z = std::max(1.5f, k.room.eaves - drop);
        if (!isClear(k.draft, {x, y, z}) || !isClear(k.draft, {x, y, z - 0.25f})) return;
        const Pen pen(k.draft, {});
        const float bulb = style == 0 ? r : std::min(r, 0.06f);
        pen.rod({x, y, z + bulb + 0.005f}, {x, y, top + 0.03f}, 0.006f, k.palette.metal.front());
        pen.sphereLight({x, y, z}, bulb, k.group, k.palette.lightBody);
        if (style == 1) pen.shade({x, y, z - 0.12f}, 0.24f, 0.12f, 0.26f, shadeMaterial);
        if (style == 2) pen.shade({x, y, z - 0.14f}, 0.2f, 0.2f, 0.28f, shadeMaterial);
    });
}

// Lights that face only the wall or the ceiling, so that the room receives only indirect light.
void wallWashers(const Kit& k) {
    const bool upward = k.rng.chance(0.5f);
    const float z = upward ? k.room.eaves - k.rng.uniform(0.25f, 0.8f) : k.rng.uniform(1, k.room.eaves - 0.4f);
    const float width = k.rng.uniform(0.2f, 2), out = k.rng.uniform(0.08f, 0.25f);
    for (int i = k.rng.integer(1, 3); i > 0; --i) {
        const Wall& w = k.rng.pick(k.room.walls);
        if (w.length < width + 0.3f) continue;
        const float u = k.rng.uniform(0.1f, w.length - width - 0.1f);
        if (!w.isFree({u, u + width, z - 0.1f, z + 0.2f})) continue;
        const Vec3 c(u + width / 2, out, z);
        if (!isClear(k.draft, w.frame.point(c)) || !isClear(k.draft, w.frame.point(c + Vec3(0, 0, 0.1f)))) continue;
        const Pen pen(k.draft, w.frame);
        if (upward) {
            // An open trough that holds the light.
            pen.box({u, 0.001f, z - 0.06f}, {u + width, out + 0.06f, z - 0.05f}, k.palette.trim);
            pen.box({u, out + 0.05f, z - 0.05f}, {u + width, out + 0.06f, z + 0.04f}, k.palette.trim);
            pen.quadLight({c.x, out / 2 + 0.02f, z - 0.045f}, {width * 0.48f, 0, 0}, {0, out * 0.4f, 0}, k.group,
                          k.palette.lightBody);
        } else {
            pen.box({u, out, z - 0.05f}, {u + width, out + 0.02f, z + 0.05f}, k.palette.trim);
            pen.quadLight({c.x, out - 0.002f, z}, {width * 0.48f, 0, 0}, {0, 0, 0.045f}, k.group, k.palette.lightBody);
        }
    }
}

void lampOn(const Kit& k, const Pen& pen, float height) {
    const float shade = height > 1 ? k.rng.uniform(0.16f, 0.28f) : k.rng.uniform(0.08f, 0.15f);
    const float shadeHeight = shade * k.rng.uniform(0.9f, 1.6f), z = height - shadeHeight;
    pen.cylinder({0, 0, 0.001f}, shade * 0.6f, 0.02f, k.palette.metal.front(), 24);
    const float bulb = shade * 0.25f;
    pen.rod({0, 0, 0.02f}, {0, 0, z + shadeHeight * 0.5f - bulb - 0.004f}, 0.01f, k.palette.metal.front());
    pen.sphereLight({0, 0, z + shadeHeight * 0.5f}, bulb, k.group, k.palette.lightBody);
    const float top = shade * k.rng.uniform(0.5f, 1);
    pen.shade({0, 0, z}, shade, top, shadeHeight, k.rng.pick(k.palette.shade));
}

void floorLamp(const Kit& k) {
    for (int attempt = 0; attempt < 20; ++attempt) {
        const float x = k.rng.uniform(0.3f, k.room.width - 0.3f), y = k.rng.uniform(0.3f, k.room.depth - 0.3f);
        const Vec3 lo(x - 0.28f, y - 0.28f, 0), hi(x + 0.28f, y + 0.28f, 1.7f);
        const bool clash = std::any_of(k.draft.footprints.begin(), k.draft.footprints.end(), [&](const OrientedBox& o) {
            const Vec3 l = o.worldLo(), h = o.worldHi();
            return lo.x < h.x && l.x < hi.x && lo.y < h.y && l.y < hi.y;
        });
        if (clash || !k.room.contains(x, y, 0.3f)) continue;
        lampOn(k, Pen(k.draft, Placement::at({x, y, 0}, 0)), k.rng.uniform(1.2f, 1.7f));
        k.draft.footprints.push_back({{}, lo, hi});
        return;
    }
}

void tableLamp(const Kit& k) {
    if (k.draft.surfaces.empty()) return floorLamp(k);
    for (int attempt = 0; attempt < 10; ++attempt) {
        const size_t i = static_cast<size_t>(k.rng.integer(0, static_cast<int>(k.draft.surfaces.size()) - 1));
        const Surface s = k.draft.surfaces[i];
        const float z = s.frame.origin.z;
        if (s.clearance < 0.45f || z > 1.3f || s.hi.y - s.lo.y < 0.15f || z + 0.5f > k.room.eaves) continue;
        lampOn(k, Pen(k.draft, s.frame), k.rng.uniform(0.28f, 0.44f));
        // The lamp stands in the middle of this surface, so nothing else may be put on it.
        k.draft.surfaces.erase(k.draft.surfaces.begin() + static_cast<std::ptrdiff_t>(i));
        return;
    }
    floorLamp(k);
}

void lightStrip(const Kit& k) {
    const Wall& w = k.rng.pick(k.room.walls);
    const float z = k.room.eaves - k.rng.uniform(0.05f, 0.3f);
    if (!w.isFree({0, w.length, z - 0.06f, z + 0.05f})) return;
    const Pen pen(k.draft, w.frame);
    pen.box({0.1f, 0.001f, z - 0.02f}, {w.length - 0.1f, 0.03f, z + 0.02f}, k.palette.trim);
    // Emits into the room, since z x x = y.
    pen.quadLight({w.length / 2, 0.032f, z}, {0, 0, 0.018f}, {w.length / 2 - 0.11f, 0, 0}, k.group,
                  k.palette.lightBody);
}

void glowingScreen(const Kit& k) {
    const Wall& w = k.rng.pick(k.room.walls);
    const float width = k.rng.uniform(0.5f, 1.4f), height = width * 0.56f, z = k.rng.uniform(0.9f, 1.2f);
    if (w.length < width + 0.4f || z + height > k.room.eaves) return;
    const float u = k.rng.uniform(0.1f, w.length - width - 0.1f);
    if (!w.isFree({u, u + width, z, z + height})) return;
    if (!isClear(k.draft, w.frame.point({u + width / 2, 0.06f, z + height / 2}))) return;
    const Pen pen(k.draft, w.frame);
    pen.box({u - 0.02f, 0.001f, z - 0.02f}, {u + width + 0.02f, 0.04f, z + height + 0.02f},
            k.palette.furniture.front());
    pen.quadLight({u + width / 2, 0.042f, z + height / 2}, {0, 0, height / 2}, {width / 2, 0, 0}, k.group,
                  k.palette.lightBody);
}

// A ring of small bulbs.
void chandelier(const Kit& k) {
    const int bulbs = k.rng.integer(5, 12);
    const float ring = k.rng.uniform(0.15f, 0.45f), r = k.rng.uniform(0.012f, 0.035f);
    const int metal = k.palette.metal.front();
    const float x = k.room.width * k.rng.uniform(0.3f, 0.7f), y = k.room.depth * k.rng.uniform(0.3f, 0.7f);
    const float top = lampHeight(k.room, x), z = std::max(1.7f, k.room.eaves - k.rng.uniform(0.3f, 1));
    if (!k.room.contains(x, y, ring + 0.1f) || !isClear(k.draft, {x, y, z})) return;
    const Pen pen(k.draft, Placement::at({x, y, 0}, 0));
    pen.rod({0, 0, z - 0.1f}, {0, 0, top + 0.03f}, 0.008f, metal);
    for (int i = 0; i < bulbs; ++i) {
        const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(bulbs);
        const Vec3 at(ring * std::cos(phi), ring * std::sin(phi), z);
        pen.rod({0, 0, z - 0.1f}, at - Vec3(0, 0, r + 0.004f), 0.005f, metal);
        pen.sphereLight(at, r, k.group, k.palette.lightBody);
    }
}

// Candles on horizontal surfaces.
void candles(const Kit& k) {
    if (k.draft.surfaces.empty()) return chandelier(k);
    for (int i = k.rng.integer(1, 8); i > 0; --i) {
        const Surface& s = k.rng.pick(k.draft.surfaces);
        const float h = k.rng.uniform(0.04f, 0.2f), r = k.rng.uniform(0.006f, 0.012f);
        const float y = k.rng.uniform(s.lo.y, s.hi.y), x = k.rng.uniform(s.lo.x, s.hi.x);
        const Vec3 at(x, y, 0);
        if (s.clearance < h + 0.06f || !isClear(k.draft, s.frame.point(at + Vec3(0, 0, h + 0.03f)))) continue;
        const Pen pen(k.draft, s.frame);
        pen.cylinder(at, 0.02f, h, k.palette.shade.front(), 16);
        pen.sphereLight(at + Vec3(0, 0, h + 0.02f + r), r, k.group, k.palette.lightBody);
    }
}

struct Lamp {
    void (*place)(const Kit&);
    float weight;
};
const std::vector<Lamp> kLamps = {{ceilingPanels, 3},    {downlights, 2}, {spots, 3},     {pendant, 2.5f},
                                  {wallWashers, 4},      {floorLamp, 2},  {tableLamp, 2}, {lightStrip, 1},
                                  {glowingScreen, 0.7f}, {chandelier, 1}, {candles, 0.7f}};

// Approximate blackbody colours from candlelight to open shade, normalised to luminance 1.
Rgb lightColor(Rng& rng) {
    Rgb c(1, 1, 1);
    const float warmth = rng.uniform(-0.25f, 0.8f);
    c = warmth > 0 ? Rgb(1, 1 - 0.4f * warmth, 1 - 0.8f * warmth) : Rgb(1 + warmth, 1 + 0.5f * warmth, 1);
    if (rng.chance(0.08f)) c = Rgb{rng.uniform(0.1f, 1), rng.uniform(0.1f, 1), rng.uniform(0.1f, 1)};
    return c * (1 / luminance(c));
}

// A sky that is brighter around the sun and towards the horizon or zenith, with clouds, above darker ground.
SkyImage paintSky(Rng& rng) {
    SkyImage image;
    image.width = 64;
    image.height = 32;
    const float horizon = rng.uniform(0.3f, 2.5f), glow = rng.uniform(0, 6), tight = rng.uniform(4, 60);
    const float glowTheta = rng.uniform(0.2f, 1.5f), glowPhi = rng.uniform(0, 2 * kPi);
    const Vec3 towards(std::sin(glowTheta) * std::cos(glowPhi), std::sin(glowTheta) * std::sin(glowPhi),
                       std::cos(glowTheta));
    const Rgb ground = randomAlbedo(rng, 0.05f, 0.5f, 0.5f);
    struct Cloud {
        Vec3 at;
        float cosine, brightness;
    };
    std::vector<Cloud> clouds;
    for (int i = rng.integer(0, 12); i > 0; --i) {
        const float z = rng.uniform(0.05f, 1), phi = rng.uniform(0, 2 * kPi), r = std::sqrt(1 - z * z);
        clouds.push_back({{r * std::cos(phi), r * std::sin(phi), z}, rng.uniform(0.85f, 0.98f), rng.uniform(0.3f, 3)});
    }
    float sum = 0, weights = 0;
    for (int y = 0; y < image.height; ++y) {
        const float theta = kPi * (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height);
        for (int x = 0; x < image.width; ++x) {
            const float phi = 2 * kPi * (static_cast<float>(x) + 0.5f) / static_cast<float>(image.width);
            const Vec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            Rgb radiance = ground;
            if (d.z > 0) {
                radiance = Rgb(1, 1, 1) * lerp(d.z, horizon, 1.f);
                for (const Cloud& c : clouds) {
                    if (dot(c.at, d) > c.cosine) radiance = radiance * c.brightness;
                }
                radiance = radiance + Rgb(1, 0.9f, 0.75f) * (glow * std::exp(tight * (dot(towards, d) - 1)));
                sum += luminance(radiance) * std::sin(theta);
                weights += std::sin(theta);
            }
            image.radiance.push_back(radiance);
        }
    }
    for (Rgb& c : image.radiance) c = c * (weights / sum);
    return image;
}

// A point slightly in front of an emitter, to test what it illuminates.
Vec3 inFrontOf(const Emitter& e) { return e.shape == EmitterShape::Sphere ? e.center : e.center + e.normal * 0.01f; }

}  // namespace

void placeLamps(const Room& room, Draft& draft, Rng& rng, const Palette& palette, const ShellLight& shell,
                int& groups) {
    const bool lit = shell.skyArea > 0 || !draft.emitters.empty();
    const int kinds = rng.integer(lit ? 0 : 1, lit ? 2 : 3);
    float total = 0;
    for (const Lamp& l : kLamps) total += l.weight;
    for (int i = 0; i < kinds; ++i) {
        float x = rng.uniform(0, total);
        for (const Lamp& l : kLamps) {
            if ((x -= l.weight) >= 0) continue;
            Rng own = rng.fork();
            l.place({room, draft, own, palette, groups});
            break;
        }
        ++groups;
    }
}

void balanceLight(const Room& room, Draft& draft, Rng& rng, const ShellLight& shell, int groups) {
    std::erase_if(draft.emitters, [&](const Emitter& e) { return !draft.inFreeSpace(inFrontOf(e)); });
    std::vector<float> area(static_cast<size_t>(groups), 0.f), weight;
    for (const Emitter& e : draft.emitters) area[static_cast<size_t>(e.group)] += e.area();
    float total = 0;
    for (int g = 0; g < groups; ++g) {
        weight.push_back(area[static_cast<size_t>(g)] > 0 ? rng.logUniform(0.15f, 1) : 0);
        total += weight.back();
    }
    const float skyWeight = shell.skyArea > 0 ? rng.logUniform(0.3f, 2) : 0;
    total += skyWeight;
    if (total == 0) return;
    // A flux that gives a mean irradiance between about one and four on the room's surfaces, if all of it arrives
    // there.
    const float flux = room.surfaceArea() * rng.logUniform(1, 4);
    for (int g = 0; g < groups; ++g) {
        if (area[static_cast<size_t>(g)] == 0) continue;
        float share = flux * weight[static_cast<size_t>(g)] / total;
        if (g == shell.corridorGroup) share *= 5;  // most of that light stays behind the door
        if (g == shell.nicheGroup || g == shell.hearthGroup) share *= 0.5f;
        const Rgb radiance = lightColor(rng) * (share / (kPi * area[static_cast<size_t>(g)]));
        for (Emitter& e : draft.emitters) {
            if (e.group == g) e.radiance = radiance;
        }
    }
    if (shell.skyArea > 0) {
        const float share = 1.5f * flux * skyWeight / total;
        const float sunShare = rng.chance(0.4f) ? rng.uniform(0.3f, 0.9f) : 0;
        const float blue = rng.uniform(0, 0.4f);
        const Rgb tint(1 - blue, 1 - 0.4f * blue, 1 + 0.3f * blue);
        if (rng.chance(0.5f)) draft.skyImage = paintSky(rng);
        draft.sky = tint * ((1 - sunShare) * share / (kPi * shell.skyArea));
        if (sunShare > 0) {
            const float elevation = rng.uniform(0.15f, 1.1f), turn = rng.uniform(-0.9f, 0.9f);
            const Placement yaw = Placement::at({0, 0, 0}, turn);
            // Below a skylight, any azimuth of the sun will do.
            const Vec3 towards = shell.skyWindowOut.z > 0.5f ? Vec3(1, 0, 0) : shell.skyWindowOut;
            draft.sunFrom = normalize(yaw.vector(towards) * std::cos(elevation) + Vec3(0, 0, std::sin(elevation)));
            const float cosine = std::max(0.3f, dot(draft.sunFrom, shell.skyWindowOut));
            draft.sun = lightColor(rng) * (sunShare * share / (cosine * shell.skyArea));
        }
    }
    if (rng.chance(0.04f)) {
        const Vec3 at(room.width / 2, rng.uniform(0.3f, 0.7f) * room.depth, room.eaves * 0.8f);
        if (room.contains(at.x, at.y, 0.1f) && draft.inFreeSpace(at))
            draft.points.push_back({at, lightColor(rng) * (0.3f * flux / (4 * kPi))});
    }
}

}  // namespace drc::interior
