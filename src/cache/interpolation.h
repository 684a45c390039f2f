// How much a radiance map counts for a pixel: the paper's weight (Jiang and Kainz), with its sign mended, and what the
// paper lacks (docs/decisions.md, "Weights of maps").
#pragma once
#include "cache/radiance_map.h"

namespace drc {

// A map as it was placed.
struct MapSite {
    Vec3 p{0.f}, n{0.f};  // world space; n unit, geometric, on the viewer's side
    Vec2 film{0.f};       // pixels
    float radius = 0;     // reach on the film, pixels
    RadianceMap front;    // about n
    RadianceMap back;     // about -n
    bool hasFront = false;
    bool hasBack = false;  // only where the surface transmits diffusely
};

// The pixel's side.
struct PixelSite {
    Vec3 p{0.f}, n{0.f};  // as above
    Vec2 film{0.f};
    float pixelSize = 0;  // world width of a pixel at p
    bool transmits = false;
};

// What a map's weight goes by. Distance: how far off it is on the film, and nothing else; to show what normals bring.
enum class Interpolation { Distance, Geometry };

// Bilinear falloff: 1 at the map, 0 at distance `radius` along either axis of the film.
float tentWeight(const Vec2& film, const Vec2& site, float radius);
// Radial falloff, for maps that do not stand on a grid.
float radialWeight(const Vec2& film, const Vec2& site, float radius);

// 1; 0 for a map that lacks a side that the pixel needs.
float presentWeight(const PixelSite& pixel, const MapSite& site);

// Geometry's share of the weight, in [0, 1]; zero for a normal at right angles or more, for a map off the pixel's
// tangent plane by more than half its reach, and for a map that lacks a side that the pixel needs.
float geometryWeight(const PixelSite& pixel, const MapSite& site);

// The same for a pixel that no map serves well: maps off its plane count, the less the farther. A smooth error of a few
// pixels at an edge is less seen than the noise of a few paths.
float relaxedWeight(const PixelSite& pixel, const MapSite& site);

}  // namespace drc
