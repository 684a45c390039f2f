#include "scene/lobes/fourier_bsdf.h"

#include "scene/lobes/local_directions.h"

namespace drc {
namespace {

float sinTheta(const Vec3& w) { return std::sqrt(w.x * w.x + w.y * w.y); }

}  // namespace

LobeValue FourierBsdf::evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
    if (wo.z == 0 || wi.z == 0) return {};
    // The table's incident direction is -wi, in which the light travels.
    const float across = sinTheta(wo) * sinTheta(wi);
    const float cosAzimuth = across > 0 ? std::clamp(-(wo.x * wi.x + wo.y * wi.y) / across, -1.f, 1.f) : 1;
    const FourierTable::Value value = table_->evaluate(-wi.z, wo.z, cosAzimuth);
    const bool scaled = mode == TransportMode::Radiance && !sameHemisphere(wo, wi);
    return {value.fCosine * ((scaled ? 1 / sqr(relativeEta(wo)) : 1) / absCosTheta(wi)), value.density};
}

LobeSample FourierBsdf::sample(const Vec3& wo, float uLobe, const Vec2& u, TransportMode mode) const {
    const auto chosen = table_->sample(wo.z, uLobe, u);
    if (!chosen) return {};
    const float sinO = sinTheta(wo), sinI = safeSqrt(1 - sqr(chosen->incident));
    const Vec2 along = sinO > 0 ? Vec2(wo.x / sinO, wo.y / sinO) : Vec2(1, 0);
    const float c = std::cos(chosen->azimuth), s = std::sin(chosen->azimuth);
    const Vec3 wi(-sinI * (along.x * c - along.y * s), -sinI * (along.x * s + along.y * c), -chosen->incident);
    const LobeValue value = evaluate(wo, wi, mode);
    LobeSample sample{.wi = wi, .f = value.f, .pdf = value.pdf, .flags = LobeFlags::Reflection | LobeFlags::Glossy};
    if (!sameHemisphere(wo, wi)) {
        sample.flags = LobeFlags::Transmission | LobeFlags::Glossy;
        sample.eta = relativeEta(wo);
    }
    return sample;
}

}  // namespace drc
