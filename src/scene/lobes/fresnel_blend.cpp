#include "scene/lobes/fresnel_blend.h"

#include "scene/lobes/fresnel.h"

namespace drc {
namespace {

// Share of the light crossing the coat at this angle that reaches the base.
float coatTransmission(float cosTheta) { return 1 - schlickWeight(0.5f * cosTheta); }

}  // namespace

Rgb FresnelBlendBase::f(const Vec3& wo, const Vec3& wi) const {
    return reflectance_ * (28 * kInvPi / 23 * coatTransmission(absCosTheta(wi)) * coatTransmission(absCosTheta(wo)));
}

// The factor 28/23 in f() makes the integral over wi equal to one.
Rgb FresnelBlendBase::albedo(const Vec3& wo) const { return reflectance_ * coatTransmission(absCosTheta(wo)); }

LobeValue FresnelBlendCoat::evaluate(const Vec3& wo, const Vec3& wi) const {
    Vec3 wh = wo + wi;
    if (lengthSquared(wh) == 0) return {};
    wh = normalize(wh);
    const float cosIH = dot(wi, wh);
    const float denominator = 4 * std::abs(cosIH) * std::max(absCosTheta(wi), absCosTheta(wo));
    if (denominator == 0) return {};
    const float d = distribution_.d(wh);
    return {fresnelSchlick(cosIH, specular_) * (d / denominator), microfacetPdf(distribution_, wo, wi, d)};
}

Rgb FresnelBlendCoat::albedo(const Vec3& wo) const { return fresnelSchlick(absCosTheta(wo), specular_); }

}  // namespace drc
