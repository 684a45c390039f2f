// "network": the U-Net trained by this project (Jiang and Kainz, section 4).
#pragma once
#include <memory>
#include <optional>

#include "maps/map_denoiser.h"
#include "neural/unet.h"

namespace drc {

// Without a precision, uses bestPrecision(weights). Throws Error if the network was trained for another projection or
// map size than `layout`.
std::unique_ptr<MapDenoiser> makeNetworkMapDenoiser(std::shared_ptr<const UNetWeights> weights, const MapLayout& layout,
                                                    std::optional<Precision> precision = {});

}  // namespace drc
