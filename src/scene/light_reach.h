// Where a light of finite size lies and which way it shines: what choosing among many needs to know (Conty Estevez and
// Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018; PBR 4e, section 12.6.3).
#pragma once
#include "scene/shape.h"

namespace drc {

struct LightReach {
    Bounds bounds;
    // Every point of the light has its own axis, for surfaces the normal, at most `spread` from this one, and shines no
    // further than `falloff` from its own. Radians. The default: everywhere.
    Vec3 axis{0, 0, 1};
    float spread = kPi;
    float falloff = kPi / 2;
    bool twoSided = false;  // shines along -axis as well
    float intensity = 0;    // luminance, W / sr: what a far point on the axis sees of the whole light
};

// Of both lights together.
LightReach merged(const LightReach& a, const LightReach& b);
// The solid angle that a reach shines into, weighted by the cosine to its nearest axis: what the surface area of a box
// is to position, for the heuristic that builds trees of lights.
float orientationMeasure(const LightReach& reach);

// A reach in the form that a point is quickly tested against.
class LightBound {
  public:
    LightBound() = default;
    explicit LightBound(const LightReach& reach);

    // About the greatest irradiance that the light could bring to p. Zero only where it cannot bring any.
    float irradiance(const Vec3& p) const {
        const Vec3 d = p - center_;
        const float distance2 = lengthSquared(d);
        if (!(distance2 > radius2_)) return intensity_ / radius2_;
        const float inverse2 = 1 / distance2;
        float cosine = dot(axis_, d) * std::sqrt(inverse2);
        if (twoSided_) cosine = std::abs(cosine);
        // The angle between axis and direction, less what the axes spread, less what the bounds subtend.
        float sine = safeSqrt(1 - cosine * cosine);
        if (cosine >= cosSpread_) {
            cosine = 1;
            sine = 0;
        } else {
            const float c = cosine * cosSpread_ + sine * sinSpread_;
            sine = sine * cosSpread_ - cosine * sinSpread_;
            cosine = c;
        }
        const float sinBounds2 = radius2_ * inverse2, cosBounds = safeSqrt(1 - sinBounds2);
        cosine = cosine >= cosBounds ? 1 : cosine * cosBounds + sine * std::sqrt(sinBounds2);
        return cosine < cosFalloff_ ? 0 : intensity_ * inverse2 * std::max(cosine, kLeastCosine);
    }

  private:
    // Lights may reach beyond 90 degrees from their axes, and at grazing angles are brighter than the bounds suggest.
    static constexpr float kLeastCosine = 0.02f;

    Vec3 center_{0.f};
    float radius2_ = 1;
    Vec3 axis_{0, 0, 1};
    float cosSpread_ = -1, sinSpread_ = 0;
    float cosFalloff_ = 0;
    float intensity_ = 0;
    bool twoSided_ = false;
};

}  // namespace drc
