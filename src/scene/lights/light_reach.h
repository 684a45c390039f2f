// Bounds of the position and emission directions of a finite light, as needed to choose among many lights (Conty
// Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018; PBR 4e, section 12.6.3).
#pragma once
#include "scene/lights/spot_falloff.h"
#include "scene/shapes/shape.h"

namespace drc {

struct LightReach {
    Bounds bounds;
    // Each point of the light has an axis of its own, such as the surface normal, which deviates from `axis` by at most
    // the angle `spread`; the point emits up to the angle `falloff` from its own axis. Radians. By default the light
    // emits in all directions.
    Vec3 axis{0, 0, 1};
    float spread = kPi;
    float falloff = kPi / 2;
    bool twoSided = false;  // also emits around -axis
    float intensity = 0;    // luminance of the whole light as seen from a distant point on the axis, W / sr

    // Sets the angles for a light whose points all emit around `axis` and fade as a spot does.
    void narrowTo(const SpotFalloff& fade) {
        spread = std::acos(fade.cosFull);
        falloff = fade.cone - spread;
    }
};

// Bounds of both lights together.
LightReach merged(const LightReach& a, const LightReach& b);
// Solid angle of the directions of emission, weighted by the cosine to the nearest axis. In the cost function for
// building light trees, it measures directions as the surface area of a box measures positions.
float orientationMeasure(const LightReach& reach);

// A LightReach in a form that is quick to evaluate for a point.
struct LightBound {
    LightBound() = default;
    explicit LightBound(const LightReach& reach);

    // Approximate upper bound of the irradiance that the light could cause at p. Zero only if no light can reach p.
    // Without branches, so that the compiler can vectorise it: see LightBounds.
    float irradiance(const Vec3& p) const {
        const Vec3 d = p - center;
        const float distance2 = lengthSquared(d);
        const float inverse2 = 1 / std::max(distance2, radius2);
        float cosine = dot(axis, d) * std::sqrt(inverse2);
        cosine = twoSided > 0 ? std::abs(cosine) : cosine;
        const float sine = safeSqrt(1 - cosine * cosine);
        // Angle between axis and direction, minus the spread of the axes, minus the angle that the bounds subtend.
        const bool within = cosine >= cosSpread;
        const float cosLess = within ? 1 : cosine * cosSpread + sine * sinSpread;
        const float sinLess = within ? 0 : sine * cosSpread - cosine * sinSpread;
        const float sinBounds2 = radius2 * inverse2, cosBounds = safeSqrt(1 - sinBounds2);
        const float least = cosLess >= cosBounds ? 1 : cosLess * cosBounds + sinLess * std::sqrt(sinBounds2);
        const float outside = least < cosFalloff ? 0 : intensity * inverse2 * std::max(least, kLeastCosine);
        return distance2 > radius2 ? outside : intensity / radius2;
    }

    // Lower bound of the cosine in irradiance(), because lights may emit beyond 90 degrees from their axes, and may be
    // brighter at grazing angles than the bounds suggest.
    static constexpr float kLeastCosine = 0.02f;

    Vec3 center{0.f};
    float radius2 = 1;
    Vec3 axis{0, 0, 1};
    float cosSpread = -1, sinSpread = 0;
    float cosFalloff = 0;
    float intensity = 0;
    float twoSided = 0;  // 0 or 1
};

// Eight bounds in structure-of-arrays layout, evaluated together. Unused ones give zero.
class alignas(32) LightBounds {
  public:
    static constexpr int kCount = 8;
    void set(int i, const LightBound& bound);
    // result: kCount values.
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
