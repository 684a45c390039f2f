#include "scene/microfacet_reflection.h"

#include "scene/local_directions.h"

namespace drc {

Rgb MicrofacetReflection::f(const Vec3& wo, const Vec3& wi) const {
    const float cosO = absCosTheta(wo), cosI = absCosTheta(wi);
    Vec3 wh = wo + wi;
    if (cosO == 0 || cosI == 0 || lengthSquared(wh) == 0) return Rgb(0.f);
    wh = normalize(wh);
    // Above the surface, so that the sign of the cosine says on which side of a dielectric the light travels.
    if (wh.z < 0) wh = -wh;
    return reflectance_ * fresnel_.eval(dot(wi, wh)) *
           (distribution_.d(wh) * distribution_.g(wo, wi) / (4 * cosI * cosO));
}

float MicrofacetReflection::pdf(const Vec3& wo, const Vec3& wi) const {
    if (!sameHemisphere(wo, wi)) return 0;
    const Vec3 wh = normalize(wo + wi);
    return distribution_.pdf(wo, wh) / (4 * dot(wo, wh));
}

LobeSample MicrofacetReflection::sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    const Vec3 wh = distribution_.sample(wo, u);
    if (dot(wo, wh) <= 0) return s;
    s.wi = reflect(wo, wh);
    // Reflected into the surface: the energy that single scattering loses.
    if (!sameHemisphere(wo, s.wi)) return s;
    s.f = f(wo, s.wi);
    s.pdf = pdf(wo, s.wi);
    s.flags = flags();
    return s;
}

}  // namespace drc
