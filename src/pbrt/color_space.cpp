#include "pbrt/color_space.h"

#include <Imath/ImathMatrix.h>

#include <algorithm>
#include <map>

#include "image/color.h"

namespace drc::pbrt {

// CIE 1931 chromaticities.
struct ColorSpace::Primaries {
    Imath::V2d red, green, blue, white;
};

namespace {

using Imath::M33d;
using Imath::V3d;

constexpr double kD65[2] = {0.3127, 0.3290};

V3d xyzOf(const Imath::V2d& xy) { return V3d(xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y); }

M33d rows(const V3d& a, const V3d& b, const V3d& c) { return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}; }

// Chromatic adaptation from one white point (XYZ) to another, by Bradford's cone responses. The matrix is for row
// vectors, like all of Imath's.
M33d adaptation(const V3d& from, const V3d& to) {
    const M33d cones = M33d(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296).transposed();
    const V3d a = from * cones, b = to * cones;
    return cones * M33d(b.x / a.x, 0, 0, 0, b.y / a.y, 0, 0, 0, b.z / a.z) * cones.inverse();
}

Rgb toRec709(const V3d& xyz) { return xyzToRgb(Vec3(float(xyz.x), float(xyz.y), float(xyz.z))); }

}  // namespace

ColorSpace::ColorSpace(const Primaries& primaries) {
    // Luminances of the primaries for which they add up to white.
    const V3d white = xyzOf(primaries.white);
    const V3d colors[] = {xyzOf(primaries.red), xyzOf(primaries.green), xyzOf(primaries.blue)};
    const V3d amounts = white * rows(colors[0], colors[1], colors[2]).inverse();
    const M33d adapt = adaptation(white, xyzOf({kD65[0], kD65[1]}));
    for (int i = 0; i < 3; ++i) {
        const V3d primary = colors[i] * amounts[i];
        light_[i] = toRec709(primary);
        reflectance_[i] = toRec709(primary * adapt);
    }
}

Rgb ColorSpace::reflectance(const Rgb& c) const {
    const Rgb plain = clampNonNegative(mix(reflectance_, c));
    const float most = std::max({plain.x, plain.y, plain.z});
    // Up to kPlain the plain colour is used, from kOther on the other one, and between them a blend.
    constexpr float kPlain = 0.8f, kOther = 1;
    if (most <= kPlain) return plain;
    // Light from all bounces between walls of albedo a, relative to the light of the lamps: a / (1 - a).
    constexpr float kMost = 1 - 1e-6f;
    const auto allBounces = [&](float a) { return std::clamp(a, 0.f, kMost) / (1 - std::clamp(a, 0.f, kMost)); };
    const Rgb sum = clampNonNegative(mix(reflectance_, Rgb(allBounces(c.x), allBounces(c.y), allBounces(c.z))));
    const Rgb other(sum.x / (1 + sum.x), sum.y / (1 + sum.y), sum.z / (1 + sum.z));
    const float share = std::clamp((most - kPlain) / (kOther - kPlain), 0.f, 1.f);
    const Rgb mixed = plain * (1 - share) + other * share;
    return Rgb(std::min(mixed.x, 1.f), std::min(mixed.y, 1.f), std::min(mixed.z, 1.f));
}

namespace {

using Spaces = std::map<std::string_view, ColorSpace>;

}  // namespace

const ColorSpace* ColorSpace::named(std::string_view name) {
    const Imath::V2d d65(kD65[0], kD65[1]);
    // ITU-R BT.709 and BT.2020, SMPTE RP 431-2's primaries with D65, SMPTE ST 2065-1.
    static const Spaces spaces = {
        {"srgb", ColorSpace({{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65})},
        {"rec2020", ColorSpace({{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65})},
        {"dci-p3", ColorSpace({{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65})},
        {"aces2065-1", ColorSpace({{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}})},
    };
    const auto found = spaces.find(name);
    return found == spaces.end() ? nullptr : &found->second;
}

std::vector<std::string_view> ColorSpace::names() { return {"srgb", "rec2020", "aces2065-1", "dci-p3"}; }

}  // namespace drc::pbrt
