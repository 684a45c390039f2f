#include "scene/lights/portal.h"

#include <fmt/core.h>

#include <cmath>

#include "math/warp.h"

namespace drc {
namespace {

// Largest deviation from right angles and parallel sides, as a cosine; the tolerance of pbrt-v4.
constexpr float kPlaneTolerance = 1e-3f;

// atan2(x, z) / pi + 1/2, for z > 0.
float rectified(float x, float z) {
    const float a = std::abs(x);
    const float half = a <= z ? 0.25f * atanInOctants(a / z) : 0.5f - 0.25f * atanInOctants(z / a);
    return std::clamp(0.5f + std::copysign(half, x), 0.f, 1.f);
}
Vec2 rectified(const Vec3& local) { return Vec2(rectified(local.x, local.z), rectified(local.y, local.z)); }
// Sine and cosine of the angle (u - 1/2) pi.
SinCos sinCosOf(float u) { return sinCosOfTurn(u < 0.5f ? 0.5f * u + 0.75f : 0.5f * u - 0.25f); }

// d(omega) / d(rectified) = pi^2 (1 - x^2) (1 - y^2) / z, for a unit w in the portal's frame.
float solidAngleAt(const Vec3& w) {
    const float perUnit = kPi * kPi * (w.y * w.y + w.z * w.z) * (w.x * w.x + w.z * w.z) / w.z;
    return std::isfinite(perUnit) ? perUnit : 0;
}

}  // namespace

Portal::Portal(const std::array<Vec3, 4>& corners) : corner_(corners[0]) {
    const Vec3 x = corners[3] - corners[0], y = corners[1] - corners[0];
    width_ = length(x);
    height_ = length(y);
    // The frame is orthonormal even if the corners are not exactly those of a rectangle.
    const Vec3 s = x / width_, n = normalize(cross(s, y));
    frame_ = Frame(s, cross(n, s), n);
}

std::string Portal::flawOf(const std::array<Vec3, 4>& corners) {
    std::array<Vec3, 4> sides;  // from each corner to the next
    for (size_t i = 0; i < 4; ++i) {
        const Vec3 side = corners[(i + 1) % 4] - corners[i];
        sides[i] = normalize(side);
        if (!(lengthSquared(sides[i]) > 0.5f))
            return fmt::format("corners {} and {} are at the same place", i + 1, (i + 1) % 4 + 1);
    }
    for (size_t i = 0; i < 4; ++i) {
        const float cosine = dot(sides[(i + 3) % 4] * -1.f, sides[i]);
        if (std::abs(cosine) > kPlaneTolerance)
            return fmt::format("the angle at corner {} is {:.4g} degrees, not 90", i + 1,
                               std::acos(std::clamp(cosine, -1.f, 1.f)) * 180 / kPi);
    }
    // Together with right angles at all corners, opposite sides in opposite directions mean that the outline is flat
    // and does not cross itself.
    for (size_t i = 0; i < 2; ++i)
        if (std::abs(dot(sides[i], sides[i + 2]) + 1) > kPlaneTolerance)
            return fmt::format("the side from corner {} to corner {} is not parallel to the opposite one", i + 1,
                               i + 2);
    return "";
}

std::array<Vec3, 4> Portal::corners() const {
    return {corner_, pointAt(Vec2(0, 1)), pointAt(Vec2(1, 1)), pointAt(Vec2(1, 0))};
}

bool Portal::isPassed(const Vec3& p, const Vec3& w) const {
    const Vec3 o = frame_.toLocal(p - corner_), d = frame_.toLocal(w);
    if (!(d.z > 0 && o.z < 0)) return false;
    const float t = -o.z / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    return x >= 0 && x <= width_ && y >= 0 && y <= height_;
}

std::optional<Window> Portal::windowFrom(const Vec3& p) const {
    const Vec3 toCorner = frame_.toLocal(corner_ - p);
    if (!(toCorner.z > 0)) return {};
    return Window{rectified(toCorner), rectified(toCorner + Vec3(width_, height_, 0))};
}

Portal::Direction Portal::directionOf(const Vec2& at) const {
    // Solves x / z = tan a and y / z = tan b with sines and cosines, since the tangents may be infinite.
    constexpr float kLeast = 1e-7f;
    const SinCos a = sinCosOf(at.x), b = sinCosOf(at.y);
    const float ca = std::max(kLeast, a.cos), cb = std::max(kLeast, b.cos);
    const Vec3 w = normalize(Vec3(a.sin * cb, b.sin * ca, ca * cb));
    if (!(w.z > 0)) return {frame_.toWorld(w), 0, 0};
    return {frame_.toWorld(w), solidAngleAt(w), w.z};
}

std::optional<Portal::Rectified> Portal::rectifiedOf(const Vec3& w) const {
    const Vec3 local = normalize(frame_.toLocal(w));
    if (!(local.z > 0)) return {};
    return Rectified{rectified(local), solidAngleAt(local), local.z};
}

}  // namespace drc
