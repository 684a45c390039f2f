#include "interior_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "generator_camera.h"
#include "generator_decor.h"
#include "generator_furniture.h"
#include "generator_lighting.h"
#include "generator_materials.h"
#include "generator_rng.h"
#include "generator_room.h"

namespace drc::interior {
namespace {

constexpr int kAttempts = 50;

std::string describe(const Room& room, const Draft& draft) {
    return fmt::format("{} walls, {:.2f} x {:.2f} x {:.2f} m, {} triangles, {} other shapes, {} area lights{}{}{}",
                       room.walls.size(), room.width, room.depth, room.eaves + room.rise, draft.triangleCount(),
                       draft.spheres.size() + draft.shapes.size(), draft.emitters.size(),
                       isBlack(draft.sky) ? "" : ", sky", isBlack(draft.sun) ? "" : ", sun",
                       draft.points.empty() ? "" : ", a point light");
}

RoomKind pickKind(Rng& rng) {
    const float x = rng.uniform();
    return x < 0.52f   ? RoomKind::Living
           : x < 0.66f ? RoomKind::Corridor
           : x < 0.78f ? RoomKind::Bath
           : x < 0.9f  ? RoomKind::Kitchen
                       : RoomKind::Hall;
}

Draft makeDraft(Rng rng) {
    Draft draft;
    Rng paletteRng = rng.fork(), shellRng = rng.fork(), thingsRng = rng.fork(), lightRng = rng.fork(),
        cameraRng = rng.fork();
    const RoomKind kind = pickKind(shellRng);
    const Palette palette = makePalette(draft, paletteRng, kind);
    Room room = makeRoom(shellRng, palette, kind);
    int groups = 0;
    const ShellLight shell = buildShell(room, draft, shellRng, palette, groups);
    const bool abstractScene = kind == RoomKind::Living && thingsRng.chance(0.2f);
    if (abstractScene) {
        scatterPrimitives(room, draft, thingsRng, palette, thingsRng.integer(3, 25));
    } else {
        furnish(room, draft, thingsRng, palette, kind, thingsRng.uniform(0.05f, 0.5f));
        if (thingsRng.chance(0.15f)) scatterPrimitives(room, draft, thingsRng, palette, thingsRng.integer(1, 6));
    }
    placeLamps(room, draft, lightRng, palette, shell, groups);
    if (thingsRng.chance(0.5f)) layRug(room, draft, thingsRng, palette);
    if (!abstractScene) decorateWalls(room, draft, thingsRng, palette);
    dressWindows(room, draft, thingsRng, palette);
    placeOrnaments(draft, thingsRng, palette, thingsRng.uniform(0, 1));
    balanceLight(room, draft, lightRng, shell, groups);
    draft.summary = describe(room, draft);
    if (!placeCamera(room, draft, cameraRng)) draft.fov = 0;
    return draft;
}

World makeWorld(Rng& rng) {
    World w;
    w.yUp = rng.chance(0.5f);
    // Metres, centimetres, millimetres / 100, inches: training must not depend on the units.
    w.scale = rng.pick(std::vector<float>{1, 1, 1, 100, 100, 10, 39.37f, 0.1f});
    const Vec3 origin{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.chance(0.5f) ? 0 : rng.uniform(-3, 3)};
    w.frame = Placement::at(origin, rng.chance(0.4f) ? 0 : rng.uniform(0, 2 * kPi));
    return w;
}

}  // namespace

std::string findFault(const Draft& draft) {
    if (draft.fov <= 0) return "no place for the camera";
    if (draft.flux() <= 0) return "no light";
    for (const Emitter& e : draft.emitters) {
        const Vec3 p = e.shape == EmitterShape::Sphere ? e.center : e.center + e.normal * 0.01f;
        if (!draft.inFreeSpace(p)) return "a light shines into something solid";
    }
    const auto holdsEye = [&](const OrientedBox& b) { return b.contains(draft.eye); };
    if (std::any_of(draft.solids.begin(), draft.solids.end(), holdsEye)) return "the camera is inside something";
    if (draft.triangleCount() > 60000) return "too many triangles";
    return {};
}

Interior generateInterior(uint64_t seed, int number, const FilmSize& film) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        Rng rng(seed, static_cast<uint64_t>(number) * kAttempts + static_cast<uint64_t>(attempt));
        Rng worldRng = rng.fork();
        Interior interior;
        interior.world = makeWorld(worldRng);
        interior.draft = makeDraft(rng.fork());
        if (!findFault(interior.draft).empty()) continue;
        interior.pbrt =
            toPbrt(interior.draft, interior.world, film, fmt::format("Interior {} of seed {}.", number, seed));
        return interior;
    }
    throw Error(
        fmt::format("room {} of seed {}: no usable room in {} attempts; use another seed", number, seed, kAttempts));
}

Interior writeInterior(const std::filesystem::path& directory, uint64_t seed, int number, const FilmSize& film) {
    Interior interior = generateInterior(seed, number, film);
    writeScene(directory / fmt::format("room-{:04}", number), interior.draft, interior.pbrt);
    return interior;
}

}  // namespace drc::interior
