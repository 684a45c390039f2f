// A conductor under a dielectric coat (pbrt-v4's "coatedconductor" in closed form; see docs/layered-materials.md). The
// reflection off the coat itself is a separate lobe, except for CoatedMirror.
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
    // Share of the light reflected by the base that its roughness scatters far enough from the mirror direction for the
    // coat's interface to reflect it totally. cosTheta, here and below: outside the coat.
    float scatteredAway(float cosTheta) const;
    // Share of the light reflected by the base that the coat sends back to the base.
    float comesBack(float cosTheta) const;

    DielectricCoat coat_;
    TrowbridgeReitz distribution_;
    Fresnel base_;
    float alpha_;    // roughness of the base
    float kept_;     // energy that single scattering off the base conserves, absorption apart
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
