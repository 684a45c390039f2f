// A finished radiance map in the form that pixels gather from: compact, with a density to sample directions by, and
// with lookups corrected for the distance between the map's origin and the point that asks.
#pragma once
#include <Imath/half.h>

#include <vector>

#include "cache/map_capture.h"

namespace drc {

class RadianceMap {
  public:
    RadianceMap() = default;
    // Reads captured.radiance as the final radiance.
    RadianceMap(const CapturedMap& captured, const MapLayout& layout);

    const Vec3& origin() const { return origin_; }
    const Vec3& normal() const { return frame_.n; }
    // Harmonic mean of the distances to what the map sees (Ward et al., "A Ray Tracing Solution for Diffuse
    // Interreflection", 1988): how far its light can be trusted to stay alike. Infinite if it sees nothing.
    float harmonicMeanDistance() const { return harmonicMeanDistance_; }

    // Radiance that arrives at the map's origin from the unit direction d (world space). A direction below the map's
    // horizon sees what the horizon sees.
    Rgb radiance(const Vec3& d) const;
    // The same at a point x near the origin: the surface that x sees along d is found by the map's distances, and its
    // radiance looked up in the direction from the origin.
    Rgb radianceAt(const Vec3& x, const Vec3& d) const;

    struct DirectionSample {
        Vec3 d;         // unit, world space
        float pdf = 0;  // per solid angle
    };
    // Density proportional to the texels' mean luminances times the cosine to the map's normal, with a share that
    // ignores luminance; uniform in solid angle inside a texel. Neighbours in u.x are neighbours on the hemisphere, so
    // that well-distributed numbers give well-distributed directions.
    DirectionSample sample(const Vec2& u) const;
    float pdf(const Vec3& d) const;

  private:
    Rgb texel(int index) const {
        const half* t = &radiance_[size_t(index) * 3];
        return Rgb(t[0], t[1], t[2]) * scale_;
    }
    // Of what the texel in that direction sees; infinite: it escaped.
    float distance(const Vec3& local) const {
        const float d = distance_[size_t(layout_.texel(local))];
        return d > 0 ? d * distanceScale_ : kInfinity;
    }
    // Bilinear between texel centres.
    Rgb lookup(const Vec3& local) const;

    MapLayout layout_{Projection::EqualArea, 32};
    Vec3 origin_{0.f};
    Frame frame_;
    std::vector<half> radiance_;   // [N*N][3], divided by scale_ so that it fits a half
    std::vector<half> distance_;   // [N*N], in units of distanceScale_; negative: escaped
    std::vector<float> cdf_;       // [N*N], cumulative along the Morton curve; the last is 1
    std::vector<uint16_t> guide_;  // for each of kGuide parts of [0,1): the place in cdf_ where it begins
    float scale_ = 1;
    float distanceScale_ = 1;
    float harmonicMeanDistance_ = kInfinity;
};

}  // namespace drc
