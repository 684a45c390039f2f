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
struct LightBound {
    LightBound() = default;
    explicit LightBound(const LightReach& reach);

    // About the greatest irradiance that the light could bring to p. Zero only where it cannot bring any. Without
    // branches, so that the compiler tests several side by side: see LightBounds.
    float irradiance(const Vec3& p) const {
        const Vec3 d = p - center;
        const float distance2 = lengthSquared(d);
        const float inverse2 = 1 / std::max(distance2, radius2);
        float cosine = dot(axis, d) * std::sqrt(inverse2);
        cosine = twoSided > 0 ? std::abs(cosine) : cosine;
        const float sine = safeSqrt(1 - cosine * cosine);
        // The angle between axis and direction, less what the axes spread, less what the bounds subtend.
        const bool within = cosine >= cosSpread;
        const float cosLess = within ? 1 : cosine * cosSpread + sine * sinSpread;
        const float sinLess = within ? 0 : sine * cosSpread - cosine * sinSpread;
        const float sinBounds2 = radius2 * inverse2, cosBounds = safeSqrt(1 - sinBounds2);
        const float least = cosLess >= cosBounds ? 1 : cosLess * cosBounds + sinLess * std::sqrt(sinBounds2);
        const float outside = least < cosFalloff ? 0 : intensity * inverse2 * std::max(least, kLeastCosine);
        return distance2 > radius2 ? outside : intensity / radius2;
    }

    // Lights may reach beyond 90 degrees from their axes, and at grazing angles are brighter than the bounds suggest.
    static constexpr float kLeastCosine = 0.02f;

    Vec3 center{0.f};
    float radius2 = 1;
    Vec3 axis{0, 0, 1};
    float cosSpread = -1, sinSpread = 0;
    float cosFalloff = 0;
    float intensity = 0;
    float twoSided = 0;  // or 1
};

// Eight bounds, field by field, tested together. Those that are not set bring nothing.
class alignas(32) LightBounds {
  public:
    static constexpr int kCount = 8;
    void set(int i, const LightBound& bound);
    // result: kCount numbers.
    void irradiance(const Vec3& p, float* result) const;

  private:
    LightBound get(int i) const {
        LightBound b;
        b.center = Vec3(center_[0][i], center_[1][i], center_[2][i]);
        b.radius2 = radius2_[i];
        b.axis = Vec3(axis_[0][i], axis_[1][i], axis_[2][i]);
        b.cosSpread = cosSpread_[i];
        b.sinSpread = sinSpread_[i];
        b.cosFalloff = cosFalloff_[i];
        b.intensity = intensity_[i];
        b.twoSided = twoSided_[i];
        return b;
    }

    float center_[3][kCount]{}, radius2_[kCount]{1, 1, 1, 1, 1, 1, 1, 1};
    float axis_[3][kCount]{}, cosSpread_[kCount]{}, sinSpread_[kCount]{}, cosFalloff_[kCount]{};
    float intensity_[kCount]{}, twoSided_[kCount]{};
};

}  // namespace drc
