// Common implementation of diffuse emitters (PBR 3e, sections 12.5 and 16.1.2).
#include "scene/light.h"

namespace drc {

std::optional<EmittedRay> AreaLight::leave(const EmitterHit& from, const Vec2& u, const SceneSphere& scene) const {
    Vec2 v = u;
    Vec3 side = from.ng;
    if (twoSided_) {
        // Half of the random numbers are for each side.
        if (u.x >= 0.5f) side = -from.ng;
        v.x = std::min(u.x >= 0.5f ? 2 * u.x - 1 : 2 * u.x, kOneMinusEpsilon);
    }
    const Vec3 d = Frame::fromNormal(side).toWorld(sampleCosineHemisphere(v));
    EmittedRay ray{
        from.p, d, from.ng, from.triangle, from.uv, 0, emission_.at(from.uv), emissionDensity(from, d, scene)};
    if (!(ray.density.leaving > 0) || !(ray.density.origin > 0)) return {};
    return ray;
}

EmissionDensity AreaLight::emissionDensity(const EmitterHit& at, const Vec3& d, const SceneSphere&) const {
    const float cosine = dot(at.ng, d);
    return {originPdf(at), twoSided_ ? 0.5f * cosineHemispherePdf(std::abs(cosine)) : cosineHemispherePdf(cosine)};
}

}  // namespace drc
