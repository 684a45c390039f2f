#include "scene/lights/light_reach.h"

namespace drc {
namespace {

struct Cone {
    Vec3 axis{0, 0, 1};
    float spread = kPi;
};

// The narrowest cone that contains both (PBR 4e, section 3.8.4).
Cone around(Cone a, Cone b) {
    if (a.spread < b.spread) std::swap(a, b);
    // Angle between the axes, by a formula that is accurate for small angles.
    const float between = 2 * std::atan2(length(a.axis - b.axis), length(a.axis + b.axis));
    if (std::min(kPi, between + b.spread) <= a.spread) return a;
    const float spread = 0.5f * (a.spread + between + b.spread);
    const Vec3 across = normalize(b.axis - a.axis * dot(a.axis, b.axis));
    if (spread >= kPi || across == Vec3(0, 0, 0)) return {};
    const float turn = spread - a.spread;
    // Enlarged, so that rounding does not exclude anything.
    return {normalize(a.axis * std::cos(turn) + across * std::sin(turn)), std::min(kPi, spread + 1e-4f)};
}

}  // namespace

LightReach merged(const LightReach& a, const LightReach& b) {
    LightReach r;
    r.bounds = a.bounds;
    r.bounds.extend(b.bounds);
    // For lights that emit in both directions, the axis may be reversed.
    const bool opposed = dot(a.axis, b.axis) < 0;
    const Vec3 axisA = opposed && a.twoSided ? -a.axis : a.axis;
    const Vec3 axisB = opposed && !a.twoSided && b.twoSided ? -b.axis : b.axis;
    const Cone cone = around({axisA, a.spread}, {axisB, b.spread});
    r.axis = cone.axis;
    r.spread = cone.spread;
    r.falloff = std::max(a.falloff, b.falloff);
    r.twoSided = a.twoSided || b.twoSided;
    r.intensity = a.intensity + b.intensity;
    return r;
}

float orientationMeasure(const LightReach& reach) {
    const float o = reach.spread, w = std::min(o + reach.falloff, kPi);
    const float sinO = std::sin(o), cosO = std::cos(o);
    const float oneSide = 2 * kPi * (1 - cosO) + kPi / 2 * (2 * w * sinO - std::cos(o - 2 * w) - 2 * o * sinO + cosO);
    return reach.twoSided ? 2 * oneSide : oneSide;
}

LightBound::LightBound(const LightReach& reach)
    : center(reach.bounds.center()),
      // Positive even for a point light, so that 1 / distance^2 stays finite beside it.
      radius2(std::max(sqr(reach.bounds.radius()), 1e-30f)),
      axis(reach.axis),
      cosSpread(reach.spread >= kPi ? -1 : std::cos(reach.spread)),
      sinSpread(reach.spread >= kPi ? 0 : std::sin(reach.spread)),
      // Lowered by the rounding error of the cosine that is compared with it.
      cosFalloff(std::cos(reach.falloff) - 1e-4f),
      intensity(reach.intensity),
      twoSided(reach.twoSided ? 1.f : 0.f) {}

void LightBounds::set(int i, const LightBound& b) {
    for (int k = 0; k < 3; ++k) {
        center_[k][i] = b.center[k];
        axis_[k][i] = b.axis[k];
    }
    radius2_[i] = b.radius2;
    cosSpread_[i] = b.cosSpread;
    sinSpread_[i] = b.sinSpread;
    cosFalloff_[i] = b.cosFalloff;
    intensity_[i] = b.intensity;
    twoSided_[i] = b.twoSided;
}

void LightBounds::irradiance(const Vec3& p, float* result) const {
    for (int i = 0; i < kCount; ++i) result[i] = get(i).irradiance(p);
}

}  // namespace drc
