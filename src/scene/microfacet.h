// The Trowbridge-Reitz (GGX) distribution of microfacets, anisotropic, with Smith masking (PBR 3e, section 8.4),
// sampled by visible normals (section 14.1.1; Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 2018).
#pragma once
#include "math/vec.h"

namespace drc {

// pbrt's map from a "roughness" in [0, 1] to alpha, for materials with remaproughness.
float roughnessToAlpha(float roughness);

class TrowbridgeReitz {
  public:
    // pbrt's lower limit: below it the lobe is a mirror to single precision.
    static constexpr float kMinAlpha = 0.001f;

    // Whether a facet that one direction sees is likelier to be seen by the other, too: high facets are. Separable
    // takes the two as independent, as Burley's model does; it is darker.
    enum class Masking { HeightCorrelated, Separable };

    TrowbridgeReitz() : TrowbridgeReitz(1, 1) {}
    TrowbridgeReitz(float alphaX, float alphaY, Masking masking = Masking::HeightCorrelated)
        : alphaX_(std::max(kMinAlpha, alphaX)),
          alphaY_(std::max(kMinAlpha, alphaY)),
          inverseX_(1 / alphaX_),
          inverseY_(1 / alphaY_),
          masking_(masking) {}

    // Density of microfacets of normal wh per unit area and solid angle; even in wh.
    float d(const Vec3& wh) const {
        // The textbook's cos^4 (1 + tan^2 (...))^2, multiplied out: no tangent that overflows at the horizon.
        const float e = sqr(wh.x * inverseX_) + sqr(wh.y * inverseY_) + wh.z * wh.z;
        return kInvPi * inverseX_ * inverseY_ / (e * e);
    }
    float lambda(const Vec3& w) const {
        const float cos2 = w.z * w.z;
        // Infinite at the horizon, which makes g1 and g vanish there.
        if (cos2 == 0) return kInfinity;
        const float alphaTan2 = (sqr(alphaX_ * w.x) + sqr(alphaY_ * w.y)) / cos2;
        return 0.5f * (std::sqrt(1 + alphaTan2) - 1);
    }
    float g1(const Vec3& w) const { return 1 / (1 + lambda(w)); }
    float g(const Vec3& wo, const Vec3& wi) const {
        return masking_ == Masking::Separable ? g1(wo) * g1(wi) : 1 / (1 + lambda(wo) + lambda(wi));
    }

    // A microfacet normal that wo sees, on wo's side of the surface. wo.z != 0.
    Vec3 sample(const Vec3& wo, const Vec2& u) const;
    // Its density, per solid angle of wh; wh must face wo.
    float pdf(const Vec3& wo, const Vec3& wh) const { return d(wh) * g1(wo) * absDot(wo, wh) / std::abs(wo.z); }

    // One number for both axes.
    float meanAlpha() const { return std::sqrt(alphaX_ * alphaY_); }
    // The same surface with normals spread further, by independent ones of this alpha.
    TrowbridgeReitz widened(float alpha) const {
        return TrowbridgeReitz(std::sqrt(sqr(alphaX_) + sqr(alpha)), std::sqrt(sqr(alphaY_) + sqr(alpha)), masking_);
    }

    // Narrower than what 32x32 texels over a hemisphere, 4.5 degrees each, and a network's blur leave of a reflection.
    bool isNarrow() const { return std::max(alphaX_, alphaY_) < kNarrowAlpha; }

  private:
    static constexpr float kNarrowAlpha = 0.2f;
    float alphaX_, alphaY_, inverseX_, inverseY_;
    Masking masking_;
};

}  // namespace drc
