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

    // HeightCorrelated: a microfacet that is visible from one direction is probably high, and thus more likely to be
    // visible from the other. Separable treats masking and shadowing as independent, as Burley's model does, and is
    // darker.
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
        // The textbook's cos^4 (1 + tan^2 (...))^2, expanded, so that no tangent overflows at the horizon.
        const float e = sqr(wh.x * inverseX_) + sqr(wh.y * inverseY_) + wh.z * wh.z;
        return kInvPi * inverseX_ * inverseY_ / (e * e);
    }
    // Masking and shadowing divided by 4 |cos wo cos wi|: the factor of d in the Torrance-Sparrow model. With the
    // cosines cancelled in Smith's function, nothing overflows at the horizon and one division remains.
    float visibility(const Vec3& wo, const Vec3& wi) const {
        const float cosO = std::abs(wo.z), cosI = std::abs(wi.z);
        const float o = stretchedLength(wo), i = stretchedLength(wi);
        return masking_ == Masking::Separable ? 1 / ((cosO + o) * (cosI + i)) : 0.5f / (o * cosI + i * cosO);
    }
    // Masking divided by |cos w|; finite at the horizon.
    float g1OverCosine(const Vec3& w) const { return 2 / (std::abs(w.z) + stretchedLength(w)); }

    // Samples a normal of a microfacet visible from wo, on wo's side of the surface. wo.z must not be 0.
    Vec3 sample(const Vec3& wo, const Vec2& u) const;
    // The pdf of sample() per solid angle of wh; wh must face wo.
    float pdf(const Vec3& wo, const Vec3& wh) const { return d(wh) * g1OverCosine(wo) * absDot(wo, wh); }

    // The geometric mean of both axes, and the larger one.
    float meanAlpha() const { return std::sqrt(alphaX_ * alphaY_); }
    float largestAlpha() const { return std::max(alphaX_, alphaY_); }
    // This distribution with its slopes blurred by an independent distribution of the given alpha: alpha^2 adds up on
    // both axes.
    TrowbridgeReitz widened(float alpha) const {
        return TrowbridgeReitz(std::sqrt(sqr(alphaX_) + sqr(alpha)), std::sqrt(sqr(alphaY_) + sqr(alpha)), masking_);
    }

  private:
    // The length of w in the space where the distribution of slopes has alpha 1: |cos w| (1 + 2 lambda(w)).
    float stretchedLength(const Vec3& w) const {
        return std::sqrt(sqr(alphaX_ * w.x) + sqr(alphaY_ * w.y) + w.z * w.z);
    }

    float alphaX_, alphaY_, inverseX_, inverseY_;
    Masking masking_;
};

}  // namespace drc
