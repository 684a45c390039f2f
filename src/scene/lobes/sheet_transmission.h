// Transmission through a rough glass sheet too thin to displace light, modelled as a microfacet reflection lobe for
// both faces together, mirrored to the other side (Burley, "Extending the Disney BRDF to a BSDF with Integrated
// Subsurface Scattering", SIGGRAPH 2015 course, section 5).
#pragma once
#include "scene/lobes/lobe_sampling.h"
#include "scene/lobes/thin_dielectric.h"

namespace drc {

class SheetTransmission {
  public:
    // distribution: microfacets that model the blur by both faces. eta: index of the glass.
    SheetTransmission(const Rgb& transmittance, const TrowbridgeReitz& distribution, float eta)
        : transmittance_(transmittance), distribution_(distribution), sheet_(eta) {}

    static constexpr LobeFlags flags() { return LobeFlags::Transmission | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const;
    Rgb albedo(const Vec3& wo) const { return transmittance_ * (1 - sheet_.reflectance(wo.z)); }

  private:
    Rgb transmittance_;
    TrowbridgeReitz distribution_;
    ThinDielectric sheet_;
};

}  // namespace drc
