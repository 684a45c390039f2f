#include "scene/lobes/disney_clearcoat.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_sampling.h"

namespace drc {
namespace {

// Reflectance at normal incidence for an index of 1.5.
const Rgb kAtNormal(0.04f);

// Smith's masking of Trowbridge and Reitz's distribution with Burley's fixed alpha of 0.25, divided by 2 cos theta.
float masking(float cosTheta) {
    constexpr float kAlpha2 = 0.0625f;
    return 1 / (cosTheta + std::sqrt(kAlpha2 + (1 - kAlpha2) * cosTheta * cosTheta));
}

}  // namespace

float DisneyClearcoat::distribution(float cosThetaH) const {
    return (alpha2_ - 1) / (kPi * std::log(alpha2_) * (1 + (alpha2_ - 1) * cosThetaH * cosThetaH));
}

LobeValue DisneyClearcoat::evaluate(const Vec3& wo, const Vec3& wi) const {
    if (!sameHemisphere(wo, wi)) return {};
    const Vec3 wh = normalize(wo + wi);
    const float cosOH = dot(wo, wh), cosH = absCosTheta(wh);
    if (!(cosOH > 0)) return {};
    const float d = distribution(cosH);
    const float g = masking(absCosTheta(wo)) * masking(absCosTheta(wi));
    return {fresnelSchlick(cosOH, kAtNormal) * (0.25f * weight_ * g * d), d * cosH / (4 * cosOH)};
}

LobeSample DisneyClearcoat::sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
    if (wo.z == 0) return {};
    const float cosH = safeSqrt((1 - std::pow(alpha2_, 1 - u.x)) / (1 - alpha2_));
    const float sinH = safeSqrt(1 - cosH * cosH);
    const SinCos phi = sinCosOfTurn(u.y);
    return sampleOffMicrofacet(*this, wo, Vec3(sinH * phi.cos, sinH * phi.sin, std::copysign(cosH, wo.z)));
}

Rgb DisneyClearcoat::albedo(const Vec3& wo) const {
    const float c = absCosTheta(wo);
    return fresnelSchlick(c, kAtNormal) * (weight_ * sqr(c * masking(c)));
}

}  // namespace drc
