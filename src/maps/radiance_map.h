// A finished radiance map in the form that pixels gather from: compact, importance sampled, with lookups that correct
// the parallax between the map's origin and the pixel's surface point.
#pragma once
#include <Imath/half.h>

#include <vector>

#include "maps/map_capture.h"

namespace drc {

class RadianceMap {
  public:
    RadianceMap() = default;
    // Uses captured.radiance as the final (denoised) radiance.
    RadianceMap(const CapturedMap& captured, const MapLayout& layout);

    const Vec3& origin() const { return origin_; }
    const Vec3& normal() const { return frame_.n; }
    // Harmonic mean of the distances to the surfaces that the map sees (Ward et al., "A Ray Tracing Solution for
    // Diffuse Interreflection", 1988), world units: the distance over which the map's radiance stays valid. Infinite if
    // the map sees no surface.
    float harmonicMeanDistance() const { return harmonicMeanDistance_; }

    // Radiance arriving at the map's origin from the unit direction d, world space. Directions below the map's horizon
    // give the radiance at the horizon.
    Rgb radiance(const Vec3& d) const;
    // radiance() with parallax correction for a point x near the origin, world space: finds the surface point that x
    // sees in direction d from the map's distances, and looks up the radiance in the direction from the origin to that
    // point.
    Rgb radianceAt(const Vec3& x, const Vec3& d) const;

    struct DirectionSample {
        Vec3 d;         // unit, world space
        float pdf = 0;  // per solid angle
    };
    // Samples a direction. The pdf is constant over a texel, and proportional to the texel's mean luminance times the
    // cosine to the map's normal, mixed with a share that ignores luminance. Texels are ordered along the Morton curve,
    // so neighbouring u.x give neighbouring directions, and well-distributed numbers give well-distributed directions.
    DirectionSample sample(const Vec2& u) const;
    float pdf(const Vec3& d) const;

  private:
    Rgb texel(int index) const {
        const half* t = &radiance_[size_t(index) * 3];
        return Rgb(t[0], t[1], t[2]) * scale_;
    }
    // Distance to the surface seen by the texel in this direction, map frame; infinite if its ray escaped.
    float distance(const Vec3& local) const {
        const float d = distance_[size_t(layout_.texel(local))];
        return d > 0 ? d * distanceScale_ : kInfinity;
    }
    // Interpolates bilinearly between texel centres. local: direction in the map's frame.
    Rgb lookup(const Vec3& local) const;

    MapLayout layout_{Projection::EqualArea, 32};
    Vec3 origin_{0.f};
    Frame frame_;
    std::vector<half> radiance_;  // [N*N][3], divided by scale_ to fit the range of a half
    std::vector<half> distance_;  // [N*N], in units of distanceScale_; negative where the ray escaped
    std::vector<float> cdf_;      // [N*N], cumulative probability along the Morton curve; the last entry is 1
    std::vector<uint16_t>
        guide_;  // for each of kGuide equal parts of [0,1), the index in cdf_ at which to start searching
    float scale_ = 1;
    float distanceScale_ = 1;
    float harmonicMeanDistance_ = kInfinity;
};

}  // namespace drc
