// The two ways in which most reflecting lobes are sampled. A lobe that uses one calls the density and the sampler of
// that way, so that they cannot disagree.
#pragma once
#include "math/warp.h"
#include "scene/lobe.h"
#include "scene/local_directions.h"
#include "scene/microfacet.h"

namespace drc {

// In proportion to the cosine, on wo's side.
inline float cosinePdf(const Vec3& wo, const Vec3& wi) { return sameHemisphere(wo, wi) ? absCosTheta(wi) * kInvPi : 0; }
template <class Lobe>
LobeSample sampleByCosine(const Lobe& lobe, const Vec3& wo, const Vec2& u) {
    LobeSample s;
    s.wi = sampleCosineHemisphere(u);
    if (wo.z < 0) s.wi.z = -s.wi.z;
    s.f = lobe.f(wo, s.wi);
    s.pdf = lobe.pdf(wo, s.wi);
    s.flags = lobe.flags();
    return s;
}

// Reflected off a microfacet that wo sees (PBR 3e, section 14.1.1).
// d: distribution.d of the normal halfway between wo and wi.
inline float microfacetPdf(const TrowbridgeReitz& distribution, const Vec3& wo, const Vec3& wi, float d) {
    return sameHemisphere(wo, wi) ? 0.25f * d * distribution.g1OverCosine(wo) : 0;
}
template <class Lobe>
LobeSample sampleByMicrofacet(const Lobe& lobe, const TrowbridgeReitz& distribution, const Vec3& wo, const Vec2& u) {
    LobeSample s;
    if (wo.z == 0) return s;
    const Vec3 wh = distribution.sample(wo, u);
    if (dot(wo, wh) <= 0) return s;
    s.wi = reflect(wo, wh);
    // Reflected into the surface: the energy that single scattering loses.
    if (!sameHemisphere(wo, s.wi)) return s;
    const LobeValue value = lobe.evaluate(wo, s.wi);
    s.f = value.f;
    s.pdf = value.pdf;
    s.flags = lobe.flags();
    return s;
}

// What kind of lobe this distribution of microfacets makes.
inline LobeFlags glossiness(const TrowbridgeReitz& distribution) {
    return distribution.isNarrow() ? LobeFlags::Narrow : LobeFlags::Glossy;
}

}  // namespace drc
