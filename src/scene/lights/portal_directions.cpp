#include "scene/lights/portal_directions.h"

namespace drc {

std::optional<PortalDirections::Sample> PortalDirections::sample(const Vec3& p, const Vec2& u) const {
    const auto window = portal_.windowFrom(p);
    if (!window) return {};
    const auto s = tables_->seen().sample(u, *window);
    if (!s) return {};
    const Portal::Direction direction = portal_.directionOf(s->at);
    const float pdf = direction.solidAngle > 0 ? s->pdf / direction.solidAngle : 0;
    if (!(pdf > 0)) return {};
    return Sample{direction.w, pdf};
}

PortalDirections::Inverse PortalDirections::inverse(const Vec3& p, const Vec3& wi, bool withU) const {
    const auto window = portal_.windowFrom(p);
    const auto at = portal_.rectifiedOf(wi);
    if (!window || !at || !(at->solidAngle > 0)) return {};
    const WindowedDistribution2D& seen = tables_->seen();
    return {seen.pdf(at->at, *window) / at->solidAngle, withU ? seen.inverse(at->at, *window) : Vec2(0, 0)};
}

LightReach PortalDirections::reach() const {
    LightReach r{{}, -portal_.outward()};
    for (const Vec3& corner : portal_.corners()) r.bounds.extend(corner);
    r.spread = 0;
    r.intensity = luminance(tables_->fluxPerArea()) * portal_.area() * kInvPi;
    return r;
}

}  // namespace drc
