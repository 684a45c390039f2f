// Correction of the indirect layer by a few path-traced samples.
//
// Radiance maps give a picture without noise but with a smooth error: where they stand too far apart for what they
// light, and where the network is off in hue. Path-traced samples of the same light have noise but no such error. The
// difference of the two, filtered along surfaces, is the smooth error; it is added to the layer. What the filter does
// not resolve stays as the maps have it.
#pragma once
#include "render/film.h"

namespace drc {

class IndirectCorrection {
  public:
    explicit IndirectCorrection(const PixelRegion& region);

    // A path-traced sample of the light that the maps hold, with the surface that the pixel sees there. albedo: of the
    // lobes that it lights, with the pixel's throughput; normal: unit; all zero where there is none.
    // sample: counts the pixel's samples from 0.
    struct Sample {
        Rgb radiance{0.f}, albedo{0.f};
        Vec3 position{0.f}, normal{0.f};
        float pixelSize = 0;  // world width of a pixel at the position
    };
    void add(int x, int y, int sample, const Sample& s, float filterWeight);

    // Adds the filtered difference to the layer, in place. Fewer than 16 samples a pixel: leaves it as it is.
    void apply(Image& indirect) const;

  private:
    // Samples are kept in groups that tell how far the difference can be believed, and whose middle ones are: a bright
    // path that only one group met must not become a blotch.
    static constexpr int kGroups = 4;

    PixelRegion region_;
    std::vector<FilmLayer> traced_;
    FilmLayer albedo_, normal_, position_, size_;
    int samples_ = 0;
};

}  // namespace drc
