// The clear coat of Burley's models ("Physically Based Shading at Disney", SIGGRAPH 2012 course, section 5.6): a second
// specular highlight of index 1.5, at a quarter of the strength. Its distribution of microfacets is that of Trowbridge
// and Reitz with an exponent of one in place of two, whose long tails match lacquer.
#pragma once
#include "scene/lobes/lobe.h"

namespace drc {

class DisneyClearcoat {
  public:
    // alpha: width of the highlight, in (0, 1).
    DisneyClearcoat(float weight, float alpha) : weight_(weight), alpha2_(alpha * alpha) {}

    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Glossy; }
    float alpha() const { return std::sqrt(alpha2_); }
    LobeValue evaluate(const Vec3& wo, const Vec3& wi) const;
    Rgb f(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).f; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi).pdf; }
    LobeSample sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const;
    Rgb albedo(const Vec3& wo) const;  // that of a smooth coat

  private:
    // Density of microfacet normals; times the cosine it integrates to one.
    float distribution(float cosThetaH) const;

    float weight_, alpha2_;
};

}  // namespace drc
