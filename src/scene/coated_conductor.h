// A conductor under a dielectric coat, without what the coat itself reflects where that is a lobe of its own
// (pbrt-v4's "coatedconductor" in closed form; see docs/layered-materials.md).
#pragma once
#include "scene/dielectric_coat.h"
#include "scene/fresnel.h"
#include "scene/lobe_sampling.h"

namespace drc {

// A rough base: microfacets seen through the coat.
class CoatedConductor {
  public:
    // coatAlpha: of the coat's upper face, which blurs what is seen through it. base: seen from within the coat.
    CoatedConductor(const DielectricCoat& coat, float coatAlpha, const TrowbridgeReitz& distribution,
                    const Fresnel& base);

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    float alpha() const { return distribution_.largestAlpha(); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;  // an estimate

  private:
    Vec3 refractIn(const Vec3& w) const;
    // Of what the base reflects along this direction, the part that roughness takes so far out of the mirror direction
    // that the coat's face may reflect it totally.
    float scatteredAway(float cosTheta) const;
    // Of what the base reflects along this direction, the part that comes back to it.
    float comesBack(float cosTheta) const;

    DielectricCoat coat_;
    TrowbridgeReitz distribution_;
    Fresnel base_;
    float alpha_;    // of the base
    float kept_;     // by one reflection off the base, of what is not absorbed
    float trapped_;  // of what is scattered away
};

// A smooth base under a smooth coat: one mirror, with the coat's own reflection.
class CoatedMirror : public MirrorLobe<CoatedMirror> {
  public:
    CoatedMirror(const DielectricCoat& coat, const Fresnel& base) : coat_(coat), base_(base) {}

    Rgb albedo(const Vec3& wo) const;  // exact

  private:
    DielectricCoat coat_;
    Fresnel base_;
};

}  // namespace drc
