#include "scene/microfacet_reflection.h"

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

}  // namespace drc
