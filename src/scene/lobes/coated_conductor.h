// A conductor under a dielectric coat, without the reflection off the coat itself, which is a lobe of its own if the
// surface is rough (pbrt-v4's "coatedconductor" in closed form; see docs/layered-materials.md).
#pragma once
#include "scene/lobes/dielectric_coat.h"
#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {

// A rough conductor: microfacets seen through the coat.
class CoatedConductor {
  public:
    // coatAlpha: roughness of the coat's interface, which blurs the base. base: Fresnel term of the base as seen from
    // inside the coat.
    CoatedConductor(const DielectricCoat& coat, float coatAlpha, const TrowbridgeReitz& distribution,
                    const Fresnel& base);

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;  // approximate

  private:
    Vec3 refractIn(const Vec3& w) const;
    // Share of the light reflected by the base along this direction that roughness scatters so far from the mirror
    // direction that the coat's interface may reflect it totally.
    float scatteredAway(float cosTheta) const;
    // Share of the light reflected by the base along this direction that the coat sends back to the base.
    float comesBack(float cosTheta) const;

    DielectricCoat coat_;
    TrowbridgeReitz distribution_;
    Fresnel base_;
    float alpha_;    // roughness of the base
    float kept_;     // share of unabsorbed light that one single-scattering reflection off the base conserves
    float trapped_;  // share of the scatteredAway() light that is totally reflected
};

// A smooth conductor under a smooth coat: a single mirror that includes the coat's own reflection.
class CoatedMirror : public MirrorLobe<CoatedMirror> {
  public:
    CoatedMirror(const DielectricCoat& coat, const Fresnel& base) : coat_(coat), base_(base) {}

    Rgb albedo(const Vec3& wo) const;  // exact

  private:
    DielectricCoat coat_;
    Fresnel base_;
};

}  // namespace drc
