#include "scene/fresnel_blend.h"

#include "math/warp.h"
#include "scene/fresnel.h"
#include "scene/local_directions.h"

namespace drc {
namespace {

// Of the light that crosses the coat at this angle, the part left to the base.
float coatTransmission(float cosTheta) { return 1 - schlickWeight(0.5f * cosTheta); }

}  // namespace

Rgb FresnelBlend::f(const Vec3& wo, const Vec3& wi) const {
    const float cosO = absCosTheta(wo), cosI = absCosTheta(wi);
    Vec3 wh = wo + wi;
    if (lengthSquared(wh) == 0) return Rgb(0.f);
    wh = normalize(wh);
    const Rgb base =
        diffuse_ * (Rgb(1.f) - specular_) * (28 * kInvPi / 23 * coatTransmission(cosI) * coatTransmission(cosO));
    const float cosIH = dot(wi, wh);
    const float denominator = 4 * std::abs(cosIH) * std::max(cosI, cosO);
    if (denominator == 0) return base;
    return base + fresnelSchlick(cosIH, specular_) * (distribution_.d(wh) / denominator);
}

float FresnelBlend::pdf(const Vec3& wo, const Vec3& wi) const {
    if (!sameHemisphere(wo, wi)) return 0;
    const Vec3 wh = normalize(wo + wi);
    return 0.5f * (absCosTheta(wi) * kInvPi + distribution_.pdf(wo, wh) / (4 * dot(wo, wh)));
}

LobeSample FresnelBlend::sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    if (uLobe < 0.5f) {
        s.wi = sampleCosineHemisphere(u);
        if (wo.z < 0) s.wi.z = -s.wi.z;
    } else {
        const Vec3 wh = distribution_.sample(wo, u);
        if (dot(wo, wh) <= 0) return s;
        s.wi = reflect(wo, wh);
    }
    if (!sameHemisphere(wo, s.wi)) return s;
    s.f = f(wo, s.wi);
    s.pdf = pdf(wo, s.wi);
    s.flags = flags();
    return s;
}

Rgb FresnelBlend::albedo(const Vec3& wo) const {
    // The base's is exact: 28/23 is what makes the integral over wi come out as one.
    const float cosO = absCosTheta(wo);
    return diffuse_ * (Rgb(1.f) - specular_) * coatTransmission(cosO) + fresnelSchlick(cosO, specular_);
}

}  // namespace drc
