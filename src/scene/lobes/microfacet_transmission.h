// Refraction through microfacets, for rough glass (Walter et al., "Microfacet Models for Refraction through Rough
// Surfaces", 2007; PBR 3e, sections 8.4.4 and 14.1.1).
#pragma once
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class MicrofacetTransmission {
  public:
    // etaA: index of refraction on the side of the shading normal; etaB: on the other side. They must differ: a
    // boundary between equal media refracts nothing, and its BTDF is a delta distribution.
    MicrofacetTransmission(const Rgb& transmittance, const TrowbridgeReitz& distribution, float etaA, float etaB)
        : transmittance_(transmittance), distribution_(distribution), etaA_(etaA), etaB_(etaB) {}

    static constexpr LobeFlags flags() { return LobeFlags::Transmission | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    Rgb f(const Vec3& wo, const Vec3& wi) const { return f(wo, wi, TransportMode::Radiance); }
    Rgb f(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;

    // Index on the far side of wo divided by the index on wo's side.
    float relativeEta(const Vec3& wo) const { return wo.z > 0 ? etaB_ / etaA_ : etaA_ / etaB_; }
    // Sets wh to the normal, above the surface, of the microfacet that refracts wi to wo. False if no microfacet that
    // both directions see does so.
    bool facet(const Vec3& wo, const Vec3& wi, Vec3& wh) const { return halfVector(wo, wi, relativeEta(wo), wh); }

  private:
    bool halfVector(const Vec3& wo, const Vec3& wi, float eta, Vec3& wh) const;

    Rgb transmittance_;
    TrowbridgeReitz distribution_;
    float etaA_, etaB_;
};

}  // namespace drc
