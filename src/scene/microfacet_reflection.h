// Glossy reflection off microfacets: the Torrance-Sparrow model (PBR 3e, sections 8.4.4 and 14.1.1).
#pragma once
#include "scene/fresnel.h"
#include "scene/lobe.h"
#include "scene/microfacet.h"

namespace drc {

class MicrofacetReflection {
  public:
    MicrofacetReflection(const Rgb& reflectance, const TrowbridgeReitz& distribution, const Fresnel& fresnel)
        : reflectance_(reflectance), distribution_(distribution), fresnel_(fresnel) {}

    LobeFlags flags() const {
        return LobeFlags::Reflection | LobeFlags::Glossy |
               (distribution_.isNarrow() ? LobeFlags::Narrow : LobeFlags::None);
    }
    Rgb f(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    // Of the smooth surface: close, and cheap.
    Rgb albedo(const Vec3& wo) const { return reflectance_ * fresnel_.eval(wo.z); }

  private:
    Rgb reflectance_;
    TrowbridgeReitz distribution_;
    Fresnel fresnel_;
};

}  // namespace drc
