#include "scene/lobes/microfacet_dielectric.h"

namespace drc {

MicrofacetDielectric::MicrofacetDielectric(const Rgb& reflectance, const Rgb& transmittance,
                                           const TrowbridgeReitz& distribution, float etaB, const Fresnel& fresnel)
    : distribution_(distribution),
      reflectance_(reflectance),
      transmittance_(transmittance),
      fresnel_(fresnel),
      boundary_(1, etaB),
      reflection_(reflectance, distribution, fresnel),
      transmission_(transmittance, distribution, 1, etaB) {}

float MicrofacetDielectric::reflects(float cosine) const {
    const float r = luminance(reflectance_ * fresnel_.eval(cosine));
    const float t = luminance(transmittance_) * (1 - boundary_.reflectance(cosine));
    return r + t > 0 ? r / (r + t) : 0;
}

Rgb MicrofacetDielectric::f(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
    return sameHemisphere(wo, wi) ? reflection_.f(wo, wi) : transmission_.f(wo, wi, mode);
}

float MicrofacetDielectric::pdf(const Vec3& wo, const Vec3& wi) const {
    if (sameHemisphere(wo, wi)) {
        const Vec3 sum = wo + wi;
        const Vec3 wh = normalize(sum) * std::copysign(1.f, sum.z);
        return reflects(dot(wo, wh)) * reflection_.pdf(wo, wi);
    }
    Vec3 wh;
    return transmission_.facet(wo, wi, wh) ? (1 - reflects(dot(wo, wh))) * transmission_.pdf(wo, wi) : 0;
}

LobeSample MicrofacetDielectric::sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    const Vec3 wh = distribution_.sample(wo, u);
    const float cosine = dot(wo, wh);
    if (cosine <= 0) return s;
    const bool reflected = uLobe < reflects(std::copysign(cosine, wo.z));
    if (reflected)
        s.wi = reflect(wo, wh);
    else if (!refract(wo, wh, 1 / transmission_.relativeEta(wo), s.wi))
        return s;
    s.wi = normalize(s.wi);
    if (sameHemisphere(wo, s.wi) != reflected) return s;  // into the surface: lost by single scattering
    s.f = f(wo, s.wi, mode);
    s.pdf = pdf(wo, s.wi);
    s.flags = LobeFlags::Glossy | (reflected ? LobeFlags::Reflection : LobeFlags::Transmission);
    if (!reflected) s.eta = transmission_.relativeEta(wo);
    return s;
}

}  // namespace drc
