// Gathers a pixel's indirect light from the radiance maps around it, by multiple importance sampling of maps and BSDF.
#pragma once
#include <span>

#include "maps/interpolation.h"
#include "transport/path_tracer.h"

namespace drc {

struct WeightedSite {
    const MapSite* site = nullptr;
    float weight = 0;  // > 0; weights need not sum to 1
};

// Estimates the integral of f L cos over the sphere, where f is the sum of the given lobes of the BSDF (the broad ones;
// glossy lobes are path-traced, see PathTracer::layers) and L is the weighted mean of the incoming radiance in the
// maps. samples: number of directions drawn from the maps. If the given lobes include a rough microfacet lobe, or if
// the map's normal differs from the pixel's, each map direction is combined with one drawn from the BSDF (balance
// heuristic). stream: random stream of the pixel. Sample s uses index firstIndex + s of the stream, so that later
// passes continue the sequence. `sites` must not be empty.
Rgb gather(const PrimaryHit& hit, const LobeMask& lobes, std::span<const WeightedSite> sites, int samples,
           uint64_t stream, uint32_t firstIndex);

}  // namespace drc
