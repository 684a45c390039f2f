#include "scene/microfacet_reflection.h"

namespace drc {

LobeValue MicrofacetReflection::evaluate(const Vec3& wo, const Vec3& wi) const {
    const float cosO = absCosTheta(wo), cosI = absCosTheta(wi);
    Vec3 wh = wo + wi;
    if (cosO == 0 || cosI == 0 || lengthSquared(wh) == 0) return {};
    wh = normalize(wh);
    // Above the surface, so that the sign of the cosine says on which side of a dielectric the light travels.
    if (wh.z < 0) wh = -wh;
    const float d = distribution_.d(wh);
    return {reflectance_ * fresnel_.eval(dot(wi, wh)) * (d * distribution_.g(wo, wi) / (4 * cosI * cosO)),
            microfacetPdf(distribution_, wo, wi, d)};
}

}  // namespace drc
