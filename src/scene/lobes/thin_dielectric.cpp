#include "scene/lobes/thin_dielectric.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/local_directions.h"

namespace drc {

float ThinDielectric::reflectance(float cosTheta) const {
    const float r = fresnelDielectric(std::abs(cosTheta), 1, eta_);
    // The series r + t r t + t r^3 t + ..., with t = 1 - r.
    return 2 * r / (1 + r);
}

LobeSample ThinDielectric::sample(const Vec3& wo, float uLobe, const Vec2&, TransportMode) const {
    LobeSample s;
    if (wo.z == 0) return s;
    const float r = reflectance(wo.z);
    const float pReflect = r / (r + (1 - r) * luminance(transmittance_));
    const bool reflects = uLobe < pReflect;
    s.wi = reflects ? Vec3(-wo.x, -wo.y, wo.z) : -wo;
    s.pdf = reflects ? pReflect : 1 - pReflect;
    s.f = (reflects ? Rgb(r) : transmittance_ * (1 - r)) * (1 / absCosTheta(s.wi));
    s.flags = (reflects ? LobeFlags::Reflection : LobeFlags::Transmission) | LobeFlags::Specular;
    return s;
}

}  // namespace drc
