// A diffuse base under a glossy coat that takes more of the light at grazing angles (Ashikhmin and Shirley, "An
// Anisotropic Phong Light Reflection Model", 2000; PBR 3e, sections 8.5 and 14.1.2).
#pragma once
#include "scene/lobe.h"
#include "scene/microfacet.h"

namespace drc {

class FresnelBlend {
  public:
    FresnelBlend(const Rgb& diffuse, const Rgb& specular, const TrowbridgeReitz& distribution)
        : diffuse_(diffuse), specular_(specular), distribution_(distribution) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    Rgb f(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;

  private:
    Rgb diffuse_, specular_;
    TrowbridgeReitz distribution_;
};

}  // namespace drc
