// Common implementation of diffuse emitters (PBR 3e, sections 12.5 and 16.1.2).
#include "scene/lights/light.h"

namespace drc {

std::optional<EmittedRay> AreaLight::leave(const EmitterHit& from, const Vec2& u, const SceneSphere& scene) const {
    Vec2 v = u;
    Vec3 side = from.ng;
    if (twoSided_) {
        // u.x < 1/2 chooses the front, u.x >= 1/2 the back.
        if (u.x >= 0.5f) side = -from.ng;
        v.x = std::min(u.x >= 0.5f ? 2 * u.x - 1 : 2 * u.x, kOneMinusEpsilon);
    }
    const Vec3 d = Frame::fromNormal(side).toWorld(sampleCosineCone(v, emission_.profile().sinReach()));
    EmittedRay ray{from.p, d, from.ng, from.triangle, from.uv, 0, emitted(from, d), emissionDensity(from, d, scene)};
    if (!(ray.density.leaving > 0) || !(ray.density.origin > 0)) return {};
    return ray;
}

EmissionDensity AreaLight::emissionDensity(const EmitterHit& at, const Vec3& d, const SceneSphere&) const {
    const float cosine = twoSided_ ? std::abs(dot(at.ng, d)) : dot(at.ng, d);
    const float sin2 = sqr(emission_.profile().sinReach());
    constexpr float kRounding = 1e-6f;  // tolerance of the squared sine at the edge of the cone
    if (1 - sqr(cosine) > sin2 + kRounding) return {originPdf(at), 0};
    return {originPdf(at), cosineHemispherePdf(cosine) * (twoSided_ ? 0.5f : 1) / sin2};
}

}  // namespace drc
