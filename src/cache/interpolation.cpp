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

namespace {

bool present(const PixelSite& pixel, const MapSite& site) {
    return site.hasFront && (!pixel.transmits || site.hasBack);
}

bool serves(const PixelSite& pixel, const MapSite& site) { return present(pixel, site) && dot(pixel.n, site.n) > 0; }

// Distance off the plane of either, in units of half the map's reach: a depth edge, or a step.
float step(const PixelSite& pixel, const MapSite& site) {
    const Vec3 d = site.p - pixel.p;
    return std::max(absDot(pixel.n, d), absDot(site.n, d)) / (0.5f * std::max(site.radius, 2.f) * pixel.pixelSize);
}

// Light changes over the distance at which the map sees surfaces; beyond that the parallax correction cannot know what
// the map did not see.
float split(const PixelSite& pixel, const MapSite& site) {
    return 1 / (1 + 4 * sqr(length(site.p - pixel.p) / site.front.harmonicMeanDistance()));
}

}  // namespace

float presentWeight(const PixelSite& pixel, const MapSite& site) { return present(pixel, site) ? 1 : 0; }

float geometryWeight(const PixelSite& pixel, const MapSite& site) {
    if (!serves(pixel, site)) return 0;
    const float s = step(pixel, site);
    return s < 1 ? sqr(dot(pixel.n, site.n)) * (1 - s) * split(pixel, site) : 0;
}

float relaxedWeight(const PixelSite& pixel, const MapSite& site) {
    if (!serves(pixel, site)) return 0;
    return sqr(dot(pixel.n, site.n)) * split(pixel, site) / (1 + sqr(step(pixel, site)));
}

}  // namespace drc
