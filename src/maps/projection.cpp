#include "maps/projection.h"

#include <bit>

#include "base/error.h"
#include "math/warp.h"

namespace drc {

const char* projectionName(Projection p) { return p == Projection::EqualArea ? "equal-area" : "latlong"; }

Projection projectionFromName(const std::string& name) {
    for (const Projection p : {Projection::EqualArea, Projection::LatLong})
        if (name == projectionName(p)) return p;
    throw Error("unknown map projection '" + name + "': it is 'equal-area' or 'latlong'");
}

MapLayout::MapLayout(Projection projection, int size) : projection_(projection), size_(size) {
    if (size < 2 || !std::has_single_bit(unsigned(size)))
        throw Error("a radiance map cannot be " + std::to_string(size) + " texels wide: that must be a power of two");
}

Vec3 MapLayout::direction(int column, int row, const Vec2& u) const {
    const float n = float(size_);
    if (projection_ == Projection::EqualArea)
        return squareToHemisphere(Vec2((float(column) + u.x) / n, (float(row) + u.y) / n));
    // Linear in cos theta, hence uniform in solid angle within the texel.
    const float top = std::cos(kPi * float(row) / n), bottom = std::cos(kPi * float(row + 1) / n);
    const float y = lerp(u.y, top, bottom);
    const float sinTheta = safeSqrt(1 - y * y);
    const float phi = kPi * (float(column) + u.x) / n;
    return Vec3(sinTheta * std::cos(phi), y, sinTheta * std::sin(phi));
}

Vec2 MapLayout::coordinates(const Vec3& d) const {
    const float n = float(size_);
    if (projection_ == Projection::EqualArea) {
        const Vec2 uv = hemisphereToSquare(d);
        return Vec2(uv.x * n, uv.y * n);
    }
    const float z = std::max(d.z, 0.f);
    const float theta = std::atan2(std::sqrt(d.x * d.x + z * z), d.y);
    const float phi = std::atan2(z, d.x);
    return Vec2(phi * kInvPi * n, theta * kInvPi * n);
}

float MapLayout::solidAngle(int row) const {
    const float n = float(size_);
    if (projection_ == Projection::EqualArea) return 2 * kPi / (n * n);
    return kPi / n * (std::cos(kPi * float(row) / n) - std::cos(kPi * float(row + 1) / n));
}

float broadAlpha(const MapLayout& layout) {
    // kSolidAngle: mean solid angle of a texel in the 32 x 32 maps for which kAlpha was chosen.
    constexpr float kAlpha = 0.2f, kSolidAngle = 2 * kPi / (32 * 32);
    return kAlpha * std::sqrt(layout.meanSolidAngle() / kSolidAngle);
}

}  // namespace drc
