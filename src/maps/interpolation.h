// Weights for interpolating the radiance maps around a pixel: the paper's weight from distance and normals, with its
// sign corrected, and additional terms for depth edges and nearby geometry.
#pragma once
#include "maps/radiance_map.h"

namespace drc {

// A radiance map and the place where it was captured.
struct MapSite {
    Vec3 p{0.f}, n{0.f};  // world space; n is the unit geometric normal on the viewer's side
    Vec2 film{0.f};       // film position, pixels
    float radius = 0;     // radius of influence on the film, pixels
    RadianceMap front;    // the hemisphere around n
    RadianceMap back;     // the hemisphere around -n
    bool hasFront = false;
    bool hasBack = false;  // only for surfaces with diffuse transmission
};

// The surface seen by a camera sample of a pixel.
struct PixelSite {
    Vec3 p{0.f}, n{0.f};  // as in MapSite
    Vec2 film{0.f};
    float pixelSize = 0;  // width of a pixel at p, in world units
    bool transmits = false;
};

// The terms in a map's weight. Distance: only the distance on the film, to show what the other terms contribute.
// Geometry: distance, normals, depth edges and nearby geometry.
enum class Interpolation { Distance, Geometry };

// Bilinear falloff for maps on a grid: 1 at the map, 0 at distance `radius` along either axis of the film.
float tentWeight(const Vec2& film, const Vec2& site, float radius);
// Linear falloff with the Euclidean distance on the film, for added maps, which are not on the grid.
float radialWeight(const Vec2& film, const Vec2& site, float radius);

// 1, or 0 if the map lacks a hemisphere that the pixel needs (pixels that transmit also need the back).
float presentWeight(const PixelSite& pixel, const MapSite& site);

// The geometric part of the weight, in [0, 1]. Zero if the normals are 90 degrees or more apart, if the map is off the
// pixel's tangent plane (or the pixel off the map's) by more than half the map's radius, or if the map lacks a
// hemisphere that the pixel needs.
float geometryWeight(const PixelSite& pixel, const MapSite& site);

// Like geometryWeight(), but for pixels that no map covers well: maps off the tangent plane also count, with a weight
// that falls with their distance from it. At an edge, a smooth error over a few pixels is less visible than the noise
// of a few paths.
float relaxedWeight(const PixelSite& pixel, const MapSite& site);

}  // namespace drc
