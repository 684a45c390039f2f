// Glossy reflection off microfacets: the Torrance-Sparrow model (PBR 3e, sections 8.4.4 and 14.1.1).
#pragma once
#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class MicrofacetReflection {
  public:
    MicrofacetReflection(const Rgb& reflectance, const TrowbridgeReitz& distribution, const Fresnel& fresnel)
        : reflectance_(reflectance), distribution_(distribution), fresnel_(fresnel) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
        return sampleByMicrofacet(*this, distribution_, wo, u);
    }
    // Albedo of the smooth surface: close to the true one, and cheap.
    Rgb albedo(const Vec3& wo) const { return reflectance_ * fresnel_.eval(wo.z); }

  private:
    Rgb reflectance_;
    TrowbridgeReitz distribution_;
    Fresnel fresnel_;
};

}  // namespace drc
