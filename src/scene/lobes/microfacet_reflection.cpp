#include "scene/lobes/microfacet_reflection.h"

namespace drc {

LobeValue MicrofacetReflection::evaluate(const Vec3& wo, const Vec3& wi) const {
    const Vec3 sum = wo + wi;
    const float l2 = lengthSquared(sum);
    if (wo.z == 0 || wi.z == 0 || l2 == 0) return {};
    // wh points above the surface, so that the sign of its cosine to wi says on which side of a dielectric the light
    // travels.
    const Vec3 wh = sum * std::copysign(1 / std::sqrt(l2), sum.z);
    const float d = distribution_.d(wh);
    return {reflectance_ * fresnel_.eval(dot(wi, wh)) * (d * distribution_.visibility(wo, wi)),
            microfacetPdf(distribution_, wo, wi, d)};
}

}  // namespace drc
