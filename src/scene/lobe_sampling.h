// The ways in which most reflecting lobes are sampled. A lobe that uses one has the density and the sampler of that
// way, so that they cannot disagree.
#pragma once
#include "math/warp.h"
#include "scene/lobe.h"
#include "scene/local_directions.h"
#include "scene/microfacet.h"

namespace drc {

// What a lobe is that reflects diffusely: Self adds f and albedo. Sampled in proportion to the cosine, on wo's side.
template <class Self>
class DiffuseReflectionLobe {
  public:
    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Diffuse; }
    static constexpr float alpha() { return kDiffuseAlpha; }
    float pdf(const Vec3& wo, const Vec3& wi) const { return sameHemisphere(wo, wi) ? absCosTheta(wi) * kInvPi : 0; }
    LobeSample sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
        LobeSample s;
        s.wi = sampleCosineHemisphere(u);
        if (wo.z < 0) s.wi.z = -s.wi.z;
        s.f = static_cast<const Self&>(*this).f(wo, s.wi);
        s.pdf = pdf(wo, s.wi);
        s.flags = flags();
        return s;
    }
};

// A mirror: Self adds albedo, of which nothing is estimated.
template <class Self>
class MirrorLobe : public SpecularLobe {
  public:
    static constexpr LobeFlags flags() { return LobeFlags::Reflection | LobeFlags::Specular; }
    LobeSample sample(const Vec3& wo, float, const Vec2&, TransportMode) const {
        LobeSample s;
        if (wo.z == 0) return s;
        s.wi = Vec3(-wo.x, -wo.y, wo.z);
        s.f = static_cast<const Self&>(*this).albedo(wo) * (1 / absCosTheta(s.wi));
        s.pdf = 1;
        s.flags = flags();
        return s;
    }
};

// A lobe's sample, once its direction is chosen by the density that evaluate() gives.
template <class Lobe>
LobeSample sampleTowards(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
    const LobeValue value = lobe.evaluate(wo, wi);
    return {.wi = wi, .f = value.f, .pdf = value.pdf, .flags = lobe.flags()};
}

// Reflected off a microfacet of this normal. No sample where wo does not see it, and where it reflects into the
// surface: the energy that single scattering loses.
template <class Lobe>
LobeSample sampleOffMicrofacet(const Lobe& lobe, const Vec3& wo, const Vec3& wh) {
    if (dot(wo, wh) <= 0) return {};
    const Vec3 wi = reflect(wo, wh);
    if (!sameHemisphere(wo, wi)) return {};
    return sampleTowards(lobe, wo, wi);
}

// Reflected off a microfacet that wo sees (PBR 3e, section 14.1.1).
// d: distribution.d of the normal halfway between wo and wi.
inline float microfacetPdf(const TrowbridgeReitz& distribution, const Vec3& wo, const Vec3& wi, float d) {
    return sameHemisphere(wo, wi) ? 0.25f * d * distribution.g1OverCosine(wo) : 0;
}
template <class Lobe>
LobeSample sampleByMicrofacet(const Lobe& lobe, const TrowbridgeReitz& distribution, const Vec3& wo, const Vec2& u) {
    if (wo.z == 0) return {};
    return sampleOffMicrofacet(lobe, wo, distribution.sample(wo, u));
}

}  // namespace drc
