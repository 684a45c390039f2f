#include "scene/lobes/fresnel_specular.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/local_directions.h"

namespace drc {

LobeSample FresnelSpecular::sample(const Vec3& wo, float uLobe, const Vec2&, TransportMode mode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    const float fresnel = fresnelDielectric(wo.z, etaA_, etaB_);
    const Rgb reflected = reflectance_ * fresnel, transmitted = transmittance_ * (1 - fresnel);
    const float r = luminance(reflected), t = luminance(transmitted);
    if (!(r + t > 0)) return s;
    // Equals the Fresnel reflectance if both colours are equally bright.
    const float pReflect = r / (r + t);
    if (uLobe < pReflect) {
        s.wi = Vec3(-wo.x, -wo.y, wo.z);
        s.f = reflected * (1 / absCosTheta(s.wi));
        s.pdf = pReflect;
        s.flags = LobeFlags::Reflection | LobeFlags::Specular;
        return s;
    }
    const float eta = wo.z > 0 ? etaB_ / etaA_ : etaA_ / etaB_;
    if (!refract(wo, Vec3(0, 0, std::copysign(1.f, wo.z)), 1 / eta, s.wi)) return s;
    const float scale = mode == TransportMode::Radiance ? 1 / (eta * eta) : 1;
    s.f = transmitted * (scale / absCosTheta(s.wi));
    s.pdf = 1 - pReflect;
    s.flags = LobeFlags::Transmission | LobeFlags::Specular;
    s.eta = eta;
    return s;
}

Rgb FresnelSpecular::albedo(const Vec3& wo) const {
    const float fresnel = fresnelDielectric(wo.z, etaA_, etaB_);
    return reflectance_ * fresnel + transmittance_ * (1 - fresnel);
}

}  // namespace drc
