// Map denoisers turn captured maps with one sample per texel into clean ones. They are interchangeable. Each keeps the
// energy of the captured map in every channel: it redistributes light but creates none.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "maps/map_capture.h"

namespace drc {

class MapDenoiser {
  public:
    virtual ~MapDenoiser() = default;
    // Replaces the radiance of each map. Thread-safe; the result for a map does not depend on the other elements of
    // `maps`.
    virtual void denoise(std::span<CapturedMap> maps, const MapLayout& layout) const = 0;
    virtual std::string name() const = 0;
    // The number of maps per batch that is most efficient.
    virtual int batchSize() const { return 8; }
};

// "none": the maps as captured. With many samples per texel, it serves as the oracle.
std::unique_ptr<MapDenoiser> makeIdentityMapDenoiser();
// "gaussian": a blur of the radiance with a standard deviation of sigma texels, as in the paper (sigma 1).
std::unique_ptr<MapDenoiser> makeGaussianMapDenoiser(float sigma);

// The largest factor by which matchEnergy scales a channel. The networks that ship with the program need smaller
// factors, except where a single bright texel makes up the whole map (docs/decisions/network-and-training.md,
// "Energy").
constexpr float kMostGain = 32;

// Gives each channel of `radiance` the solid-angle-weighted mean of `captured`, up to rounding. Both are planar,
// [3][N*N], and not negative. Normally the channel is scaled. If it has less than 1 / kMostGain of the captured energy,
// it says little about where the light is: then it is scaled by kMostGain, and the missing energy is spread evenly over
// the map. A channel that is black, or whose sum is not finite, becomes the captured mean everywhere.
void matchEnergy(std::span<const float> captured, const MapLayout& layout, std::span<float> radiance);

}  // namespace drc
