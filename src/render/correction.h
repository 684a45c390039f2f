// Correction of the indirect layer by a few path-traced samples.
//
// Radiance maps give a picture with little noise but with errors of their own: where they stand too far apart for what
// they light, and where the network is off in hue. Path-traced samples of the same light have noise but no such error.
// The difference of the two is averaged along surfaces at several scales; of each scale, what stands out from the
// samples' noise is added to the layer. With ever more samples that is all of the difference, down to single pixels.
#pragma once
#include "integrators/path_tracer.h"
#include "render/film.h"

namespace drc {

class IndirectCorrection {
  public:
    explicit IndirectCorrection(const PixelRegion& region);

    // Samples are kept in groups, independent of each other, that tell how far the difference can be believed.
    static constexpr int kGroups = 4;
    // A sample of the light that the maps hold (along.wide), for a group from 0 to kGroups - 1. Not looked: the camera
    // let nothing through, which darkens the pixel, but says nothing of the surface that it shows.
    void add(int x, int y, int group, const IndirectAlong& along, float filterWeight, bool looked = true);

    // Adds the filtered difference to the layer, in place. A group without samples: leaves it as it is.
    void apply(Image& indirect) const;

  private:
    PixelRegion region_;
    std::vector<FilmLayer> traced_;
    FilmLayer albedo_, normal_, position_, size_;
};

}  // namespace drc
