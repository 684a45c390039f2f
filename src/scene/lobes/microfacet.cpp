#include "scene/lobes/microfacet.h"

#include "math/warp.h"

namespace drc {

float roughnessToAlpha(float roughness) {
    const float x = std::log(std::max(roughness, 1e-3f));
    return 1.62142f + x * (0.819955f + x * (0.1734f + x * (0.0171201f + x * 0.000640711f)));
}

Vec3 TrowbridgeReitz::sample(const Vec3& wo, const Vec2& u) const {
    const bool below = wo.z < 0;
    const Vec3 w = below ? -wo : wo;
    // In stretched space the distribution is the uniform hemisphere. Its projection along w is half a disk and half an
    // ellipse: the disk's other half, foreshortened by the horizon.
    const Vec3 v = normalize(Vec3(alphaX_ * w.x, alphaY_ * w.y, w.z));
    const float l2 = v.x * v.x + v.y * v.y;
    const Vec3 t1 = l2 > 0 ? Vec3(-v.y, v.x, 0) * (1 / std::sqrt(l2)) : Vec3(1, 0, 0);
    const Vec3 t2 = cross(v, t1);
    const Vec2 p = sampleConcentricDisk(u);
    const float y = lerp(0.5f * (1 + v.z), safeSqrt(1 - p.x * p.x), p.y);
    const Vec3 n = t1 * p.x + t2 * y + v * safeSqrt(1 - p.x * p.x - y * y);
    const Vec3 wh = normalize(Vec3(alphaX_ * n.x, alphaY_ * n.y, std::max(1e-6f, n.z)));
    return below ? -wh : wh;
}

}  // namespace drc
