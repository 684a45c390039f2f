// A diffuse base under a glossy coat that reflects more light at grazing angles (Ashikhmin and Shirley, "An Anisotropic
// Phong Light Reflection Model", 2000; PBR 3e, sections 8.5 and 14.1.2). Base and coat are separate lobes, so that each
// is sampled in proportion to its albedo, and so that the base can use radiance maps when the coat is too sharp for
// them.
#pragma once
#include "scene/lobes/lobe_sampling.h"

namespace drc {

class FresnelBlendBase : public DiffuseReflectionLobe<FresnelBlendBase> {
  public:
    // Both colours determine how much light the coat leaves to the base.
    FresnelBlendBase(const Rgb& diffuse, const Rgb& specular) : reflectance_(diffuse * (Rgb(1.f) - specular)) {}

    Rgb f(const Vec3& wo, const Vec3& wi) const;
    Rgb albedo(const Vec3& wo) const;  // exact
    Rgb viewFactor(const Vec3& wo) const { return albedo(wo); }

  private:
    Rgb reflectance_;
};

class FresnelBlendCoat {
  public:
    FresnelBlendCoat(const Rgb& specular, const TrowbridgeReitz& distribution)
        : specular_(specular), distribution_(distribution) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
        return sampleByMicrofacet(*this, distribution_, wo, u);
    }
    Rgb albedo(const Vec3& wo) const;  // that of the smooth surface

  private:
    Rgb specular_;
    TrowbridgeReitz distribution_;
};

}  // namespace drc
