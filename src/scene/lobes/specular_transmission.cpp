#include "scene/lobes/specular_transmission.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/local_directions.h"

namespace drc {

LobeSample SpecularTransmission::sample(const Vec3& wo, float, const Vec2&, TransportMode mode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    const float eta = wo.z > 0 ? etaB_ / etaA_ : etaA_ / etaB_;
    if (!refract(wo, Vec3(0, 0, std::copysign(1.f, wo.z)), 1 / eta, s.wi)) return s;
    const float scale = mode == TransportMode::Radiance ? 1 / (eta * eta) : 1;
    s.f = albedo(wo) * (scale / absCosTheta(s.wi));
    s.pdf = 1;
    s.flags = flags();
    s.eta = eta;
    return s;
}

Rgb SpecularTransmission::albedo(const Vec3& wo) const {
    return transmittance_ * (1 - fresnelDielectric(wo.z, etaA_, etaB_));
}

}  // namespace drc
