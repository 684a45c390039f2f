// Gathers a pixel's indirect light from the radiance maps around it, by multiple importance sampling of map and BSDF.
#pragma once
#include <span>

#include "maps/interpolation.h"
#include "transport/path_tracer.h"

namespace drc {

struct WeightedSite {
    const MapSite* site = nullptr;
    float weight = 0;  // > 0; weights need not sum to 1
};

// Estimates the integral of f L cos over the sphere, where f are the given lobes of the BSDF (the broad ones; glossy
// ones are path-traced, see PathTracer::layers) and L is the weighted mean of the incoming radiance in the maps.
// samples: number of directions drawn from the maps. If the BSDF has a rough microfacet lobe among them, or the map's
// normal differs from the pixel's, each is combined with one direction drawn from the BSDF (balance heuristic). Sample
// s of pixel `stream` uses the sample index firstIndex + s, so that later passes continue the same sequence. `sites`
// must not be empty.
Rgb gather(const PrimaryHit& hit, const LobeMask& lobes, std::span<const WeightedSite> sites, int samples,
           uint64_t stream, uint32_t firstIndex);

}  // namespace drc
