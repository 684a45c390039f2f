#include "cache/interpolation.h"

namespace drc {

float tentWeight(const Vec2& film, const Vec2& site, float radius) {
    const float x = 1 - std::abs(film.x - site.x) / radius, y = 1 - std::abs(film.y - site.y) / radius;
    return x > 0 && y > 0 ? x * y : 0;
}

float radialWeight(const Vec2& film, const Vec2& site, float radius) {
    const Vec2 d = film - site;
    return std::max(0.f, 1 - std::sqrt(d.x * d.x + d.y * d.y) / radius);
}

float geometryWeight(const PixelSite& pixel, const MapSite& site) {
    if (!site.hasFront || (pixel.transmits && !site.hasBack)) return 0;
    const float cosine = dot(pixel.n, site.n);
    if (cosine <= 0) return 0;
    const Vec3 d = site.p - pixel.p;
    // Off the plane of either: a depth edge, or a step.
    const float reach = 0.5f * std::max(site.radius, 2.f) * pixel.pixelSize;
    const float height = std::max(absDot(pixel.n, d), absDot(site.n, d));
    if (height >= reach) return 0;
    // Light changes over the distance at which the map sees surfaces; beyond that the parallax correction cannot know
    // what the map did not see.
    const float split = length(d) / site.front.harmonicMeanDistance();
    return sqr(cosine) * (1 - height / reach) / (1 + 4 * sqr(split));
}

}  // namespace drc
