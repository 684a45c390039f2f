#include "scene/lobes/microfacet_transmission.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/local_directions.h"

namespace drc {

bool MicrofacetTransmission::halfVector(const Vec3& wo, const Vec3& wi, float eta, Vec3& wh) const {
    if (wo.z * wi.z >= 0) return false;
    wh = wo + wi * eta;
    const float l2 = lengthSquared(wh);
    if (!(l2 > 0)) return false;
    wh = wh * ((wh.z < 0 ? -1 : 1) / std::sqrt(l2));
    // A facet that is seen from behind by either direction is hidden by the rest of the surface. sample() never returns
    // directions with such a facet, so f and pdf must be zero for them.
    return dot(wo, wh) * wo.z > 0 && dot(wi, wh) * wi.z > 0;
}

Rgb MicrofacetTransmission::f(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
    const float eta = relativeEta(wo);
    Vec3 wh;
    if (!halfVector(wo, wi, eta, wh)) return Rgb(0.f);
    const float cosOH = dot(wo, wh), cosIH = dot(wi, wh);
    const float transmitted = 1 - fresnelDielectric(cosOH, etaA_, etaB_);
    // The scale of radiance by 1 / eta^2 cancels the factor eta^2 of the Jacobian, which remains for importance.
    const float scale = mode == TransportMode::Radiance ? 1 : eta * eta;
    return transmittance_ * (transmitted * scale * 4 * distribution_.d(wh) * distribution_.visibility(wo, wi) *
                             std::abs(cosIH * cosOH) / sqr(cosOH + eta * cosIH));
}

float MicrofacetTransmission::pdf(const Vec3& wo, const Vec3& wi) const {
    const float eta = relativeEta(wo);
    Vec3 wh;
    if (!halfVector(wo, wi, eta, wh)) return 0;
    const float cosIH = dot(wi, wh);
    const float jacobian = std::abs(eta * eta * cosIH / sqr(dot(wo, wh) + eta * cosIH));
    return distribution_.pdf(wo, wh) * jacobian;
}

LobeSample MicrofacetTransmission::sample(const Vec3& wo, float, const Vec2& u, TransportMode mode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    const Vec3 wh = distribution_.sample(wo, u);
    const float eta = relativeEta(wo);
    if (dot(wo, wh) <= 0 || !refract(wo, wh, 1 / eta, s.wi)) return s;
    s.wi = normalize(s.wi);
    s.f = f(wo, s.wi, mode);
    s.pdf = pdf(wo, s.wi);
    s.flags = flags();
    s.eta = eta;
    return s;
}

Rgb MicrofacetTransmission::albedo(const Vec3& wo) const {
    return transmittance_ * (1 - fresnelDielectric(wo.z, etaA_, etaB_));
}

}  // namespace drc
