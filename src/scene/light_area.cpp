// Common implementation of diffuse emitters (PBR 3e, sections 12.5 and 16.1.2).
#include "scene/light.h"

namespace drc {

std::optional<EmittedRay> AreaLight::leave(const Vec3& p, const Vec3& ng, const Vec2& u,
                                           const SceneSphere& scene) const {
    Vec2 v = u;
    Vec3 side = ng;
    if (twoSided_) {
        // Half of the random numbers are for each side.
        if (u.x >= 0.5f) side = -ng;
        v.x = std::min(u.x >= 0.5f ? 2 * u.x - 1 : 2 * u.x, kOneMinusEpsilon);
    }
    const Vec3 d = Frame::fromNormal(side).toWorld(sampleCosineHemisphere(v));
    EmittedRay ray{p, d, ng, 0, 0, radiance_, emissionDensity(ng, d, scene)};
    if (!(ray.density.leaving > 0)) return {};
    return ray;
}

EmissionDensity AreaLight::emissionDensity(const Vec3& ng, const Vec3& d, const SceneSphere&) const {
    const float cosine = dot(ng, d);
    return {1 / area(), twoSided_ ? 0.5f * cosineHemispherePdf(std::abs(cosine)) : cosineHemispherePdf(cosine)};
}

}  // namespace drc
