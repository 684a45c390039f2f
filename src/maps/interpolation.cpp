#include "maps/interpolation.h"

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

// Distance of each point from the other's tangent plane, the larger of the two, in units of half the map's radius of
// influence (which counts as at least 2 pixels). Large across depth edges and steps.
float planeOffset(const PixelSite& pixel, const MapSite& site) {
    const Vec3 d = site.p - pixel.p;
    return std::max(absDot(pixel.n, d), absDot(site.n, d)) / (0.5f * std::max(site.radius, 2.f) * pixel.pixelSize);
}

// Weight for the parallax between map and pixel. The map's radiance is valid over about the harmonic mean distance to
// the surfaces that the map sees; beyond that, parallax correction cannot recover what was hidden from the map.
float proximity(const PixelSite& pixel, const MapSite& site) {
    return 1 / (1 + 4 * sqr(length(site.p - pixel.p) / site.front.harmonicMeanDistance()));
}

}  // namespace

float presentWeight(const PixelSite& pixel, const MapSite& site) { return present(pixel, site) ? 1 : 0; }

float geometryWeight(const PixelSite& pixel, const MapSite& site) {
    if (!serves(pixel, site)) return 0;
    const float s = planeOffset(pixel, site);
    return s < 1 ? sqr(dot(pixel.n, site.n)) * (1 - s) * proximity(pixel, site) : 0;
}

float relaxedWeight(const PixelSite& pixel, const MapSite& site) {
    if (!serves(pixel, site)) return 0;
    return sqr(dot(pixel.n, site.n)) * proximity(pixel, site) / (1 + sqr(planeOffset(pixel, site)));
}

}  // namespace drc
