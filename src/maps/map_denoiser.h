// Map denoisers: they turn captured one-sample maps into clean ones. They are interchangeable, and each keeps the
// energy of the captured map, channel by channel, so that it moves light around but creates none.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "maps/map_capture.h"

namespace drc {

class MapDenoiser {
  public:
    virtual ~MapDenoiser() = default;
    // Replaces the radiance of each map. Thread-safe; the result of a map does not depend on its neighbours in `maps`.
    virtual void denoise(std::span<CapturedMap> maps, const MapLayout& layout) const = 0;
    virtual std::string name() const = 0;
    // The number of maps in an efficient batch.
    virtual int batchSize() const { return 8; }
};

// "none": the maps as captured. The oracle is this with many samples a texel.
std::unique_ptr<MapDenoiser> makeIdentityMapDenoiser();
// "gaussian": a blur of the radiance by sigma texels, as in the paper (sigma 1).
std::unique_ptr<MapDenoiser> makeGaussianMapDenoiser(float sigma);

// The largest factor by which matchEnergy scales a channel. The networks that come with the program ask for less,
// except where one bright texel is all of a map (docs/decisions/network-and-training.md, "Energy").
constexpr float kMostGain = 32;

// Gives each channel of `radiance` the solid-angle-weighted mean of `captured` (both planar [3][N*N], not negative), to
// within rounding. The channel is scaled; but if it has less than 1 / kMostGain of the captured energy, it says little
// about where the light is: then it is scaled by kMostGain, and the missing energy is spread evenly over the map. A
// channel without light, or whose sum is not finite, becomes the captured mean everywhere.
void matchEnergy(std::span<const float> captured, const MapLayout& layout, std::span<float> radiance);

}  // namespace drc
