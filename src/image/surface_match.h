// Finds where another frame of an animation shows the points that this frame shows.
#pragma once
#include <array>
#include <unordered_map>
#include <vector>

#include "image/frame_surfaces.h"
#include "image/motion_vectors.h"

namespace drc {

// Pixels of the other frame, with weights that add up to 1; none if it does not show the point.
struct MatchedPixels {
    struct Pixel {
        int x, y;
        float weight;
    };
    std::array<Pixel, 4> pixels{};
    int count = 0;
    // The share of the interpolation between four pixels that these stand for, in [0, 1].
    float seen = 0;
    Vec2 place{0.f};  // of the point, in pixels of the other frame, whole numbers at their centres
};

// Follows the point of a pixel by the cameras and by the matrices of its object, and takes those of the four pixels
// around its place that show the same object, facing, plane and, within a factor, albedo. Points that are reflected or
// refracted are not followed: as for the camera, the mirror or the glass is what moves. Where neither frame shows a
// surface and the camera stands still, a pixel matches itself.
class SurfaceMatch {
  public:
    // Both must outlive the object. Throws Error, naming both, if they are not of the same size and place.
    SurfaceMatch(const FrameSurfaces& now, const FrameSurfaces& other);

    // For a pixel of `now`. Any number of threads may call it.
    MatchedPixels at(int x, int y) const;
    // The nearest of the matched pixels, for light that must not be interpolated; null if it does not serve. Where
    // a surface meets a lamp or the sky, it must lie at the very place: a pixel has its own share of the light, and the
    // edge would become ragged.
    const MatchedPixels::Pixel* nearest(int x, int y, const MatchedPixels& match) const;
    // The albedo of the pixel in `now` divided by that of one in the other frame, in channel c.
    float albedoRatio(int x, int y, const MatchedPixels::Pixel& pixel, int c) const;

  private:
    struct Motion {
        bool moves = false;
        Transform toOther;
    };
    bool showsSame(int ox, int oy, int x, int y, const Vec3& there, const Vec3& normal) const;

    const FrameSurfaces &now_, &other_;
    FilmSize film_;
    bool sameCamera_;
    std::unordered_map<uint32_t, Motion> motions_;       // by object
    std::vector<uint8_t> silhouettes_, itsSilhouettes_;  // of lamps and sky, in `now` and in the other frame
};

}  // namespace drc
