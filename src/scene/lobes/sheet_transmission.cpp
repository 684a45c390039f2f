#include "scene/lobes/sheet_transmission.h"

namespace drc {
namespace {

Vec3 mirrored(const Vec3& w) { return {w.x, w.y, -w.z}; }

}  // namespace

LobeValue SheetTransmission::evaluate(const Vec3& wo, const Vec3& wi) const {
    const Vec3 i = mirrored(wi);
    if (!sameHemisphere(wo, i)) return {};
    const Vec3 wh = normalize(wo + i);
    const float d = distribution_.d(wh);
    return {transmittance_ * ((1 - sheet_.reflectance(dot(wo, wh))) * d * distribution_.visibility(wo, i)),
            microfacetPdf(distribution_, wo, i, d)};
}

LobeSample SheetTransmission::sample(const Vec3& wo, float, const Vec2& u, TransportMode) const {
    if (wo.z == 0) return {};
    const Vec3 wh = distribution_.sample(wo, u);
    if (dot(wo, wh) <= 0) return {};
    const Vec3 i = reflect(wo, wh);
    if (!sameHemisphere(wo, i)) return {};
    return sampleTowards(*this, wo, mirrored(i));
}

}  // namespace drc
