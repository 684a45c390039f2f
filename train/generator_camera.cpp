#include "generator_camera.h"

#include <algorithm>

namespace drc::interior {
namespace {

constexpr float kClearance = 0.2f;

float firstHit(const Room& room, const Draft& draft, const Vec3& eye, const Vec3& direction) {
    float nearest = room.hit(eye, direction);
    for (const OrientedBox& b : draft.solids) nearest = std::min(nearest, b.hit(eye, direction));
    return nearest;
}

// Rates a view by the distances over a coarse grid of rays. A good view is deep, and nothing is right in front of the
// lens.
float viewScore(const Room& room, const Draft& draft, const Vec3& eye, const Vec3& look, float fov) {
    const Vec3 z = normalize(look - eye);
    const Vec3 x = normalize(cross(z, Vec3(0, 0, 1)));
    const Vec3 y = cross(x, z);
    const float extent = std::tan(fov * kPi / 360);
    float sum = 0, nearest = kInfinity;
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            const Vec3 d =
                z + x * (extent * 0.6f * static_cast<float>(i)) + y * (extent * 0.45f * static_cast<float>(j));
            const float t = firstHit(room, draft, eye, normalize(d));
            sum += std::min(t, 6.f);
            nearest = std::min(nearest, t);
        }
    }
    return nearest < 0.35f ? -1 : sum / 25;
}

}  // namespace

bool placeCamera(const Room& room, Draft& draft, Rng& rng) {
    const float fov = rng.uniform(42, 95);
    float best = 0.9f;
    bool found = false;
    for (int attempt = 0; attempt < 80; ++attempt) {
        const Vec3 eye{rng.uniform(0, room.width), rng.uniform(0, room.depth),
                       rng.uniform(0.5f, std::min(2.1f, room.eaves - 0.3f))};
        if (!room.contains(eye.x, eye.y, kClearance)) continue;
        // Tests the bounding boxes of furniture, not their parts, so that the camera is not put under a table.
        const auto blocks = [&](const OrientedBox& b) { return b.contains(eye, kClearance); };
        if (std::any_of(draft.footprints.begin(), draft.footprints.end(), blocks)) continue;
        if (std::any_of(draft.solids.begin(), draft.solids.end(), blocks)) continue;
        const auto tooClose = [&](const Emitter& e) { return length(e.center - eye) < e.radius + 0.4f; };
        if (std::any_of(draft.emitters.begin(), draft.emitters.end(), tooClose)) continue;
        const float yaw = rng.uniform(0, 2 * kPi), pitch = rng.uniform(-0.35f, 0.2f);
        const Vec3 look = eye + Vec3(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch));
        // Randomised, so that it is not always the deepest view: close-ups are useful for training too.
        const float score = viewScore(room, draft, eye, look, fov) * rng.uniform(0.6f, 1);
        if (score <= best) continue;
        best = score;
        found = true;
        draft.eye = eye;
        draft.look = look;
        draft.fov = fov;
    }
    return found;
}

}  // namespace drc::interior
