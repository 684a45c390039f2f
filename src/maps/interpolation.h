// Weights by which the radiance maps around a pixel are interpolated: the paper's weight by distance and normals, with
// its sign corrected, and additional terms for depth edges and nearby geometry.
#pragma once
#include "maps/radiance_map.h"

namespace drc {

// A radiance map and where it was captured.
struct MapSite {
    Vec3 p{0.f}, n{0.f};  // world space; n is the unit geometric normal on the viewer's side
    Vec2 film{0.f};       // film position, pixels
    float radius = 0;     // radius of influence on the film, pixels
    RadianceMap front;    // the hemisphere around n
    RadianceMap back;     // the hemisphere around -n
    bool hasFront = false;
    bool hasBack = false;  // only where the surface has diffuse transmission
};

// The surface that a pixel's sample sees.
struct PixelSite {
    Vec3 p{0.f}, n{0.f};  // as in MapSite
    Vec2 film{0.f};
    float pixelSize = 0;  // width of a pixel at p, in world units
    bool transmits = false;
};

// Terms of a map's weight. Distance: the distance on the film alone, to show what the other terms contribute.
// Geometry: distance, normals, depth edges and nearby geometry.
enum class Interpolation { Distance, Geometry };

// Bilinear falloff for maps on a grid: 1 at the map, 0 at distance `radius` along either axis of the film.
float tentWeight(const Vec2& film, const Vec2& site, float radius);
// Linear falloff with the Euclidean distance on the film, for maps that are not on a grid.
float radialWeight(const Vec2& film, const Vec2& site, float radius);

// 1, or 0 if the map lacks a hemisphere that the pixel needs (the back, if the pixel transmits).
float presentWeight(const PixelSite& pixel, const MapSite& site);

// Geometric part of the weight, in [0, 1]. Zero if the normals are at 90 degrees or more, if the map lies off the
// pixel's tangent plane (or the pixel off the map's) by more than half the map's radius, or if it lacks a hemisphere
// that the pixel needs.
float geometryWeight(const PixelSite& pixel, const MapSite& site);

// Like geometryWeight(), but for pixels that no map serves well: maps off the tangent plane also count, the less the
// farther off they are. A smooth error over a few pixels at an edge is less visible than the noise of a few paths.
float relaxedWeight(const PixelSite& pixel, const MapSite& site);

}  // namespace drc
