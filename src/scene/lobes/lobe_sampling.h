// The sampling strategies of most reflecting lobes. Each comes as a pair of pdf and sampler, so that the two cannot
// disagree.
#pragma once
#include "math/warp.h"
#include "scene/lobes/lobe.h"
#include "scene/lobes/local_directions.h"
#include "scene/lobes/microfacet.h"

namespace drc {

// Base of diffusely reflecting lobes, which samples wi in proportion to the cosine, on wo's side. Self adds f and
// albedo.
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

// Base of mirrors. Self adds albedo, which must be exact, because it is the weight of the samples.
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

// Completes the sample of a lobe whose direction was sampled with the pdf of evaluate().
template <class Lobe>
LobeSample sampleTowards(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
    const LobeValue value = lobe.evaluate(wo, wi);
    return {.wi = wi, .f = value.f, .pdf = value.pdf, .flags = lobe.flags()};
}

// The sample for reflection off a microfacet with the normal wh. Its pdf is 0 if wo does not see the microfacet, or if
// wi points into the surface: the latter is the energy that single scattering loses.
template <class Lobe>
LobeSample sampleOffMicrofacet(const Lobe& lobe, const Vec3& wo, const Vec3& wh) {
    if (dot(wo, wh) <= 0) return {};
    const Vec3 wi = reflect(wo, wh);
    if (!sameHemisphere(wo, wi)) return {};
    return sampleTowards(lobe, wo, wi);
}

// Sampling by visible microfacets: a normal that wo sees is sampled, and wo reflected off it (PBR 3e, section 14.1.1).
// d: distribution.d of the half vector of wo and wi.
inline float microfacetPdf(const TrowbridgeReitz& distribution, const Vec3& wo, const Vec3& wi, float d) {
    return sameHemisphere(wo, wi) ? 0.25f * d * distribution.g1OverCosine(wo) : 0;
}
template <class Lobe>
LobeSample sampleByMicrofacet(const Lobe& lobe, const TrowbridgeReitz& distribution, const Vec3& wo, const Vec2& u) {
    if (wo.z == 0) return {};
    return sampleOffMicrofacet(lobe, wo, distribution.sample(wo, u));
}

}  // namespace drc
