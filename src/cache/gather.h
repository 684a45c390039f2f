// Indirect light of a pixel from the maps around it: multiple importance sampling between a map and the BSDF.
#pragma once
#include <span>

#include "cache/interpolation.h"
#include "integrators/path_tracer.h"

namespace drc {

struct WeightedSite {
    const MapSite* site = nullptr;
    float weight = 0;  // > 0; need not be normalised
};

// Estimate of the integral over the sphere of f R cos, f those lobes (the broad ones; others are traced: see
// PathTracer::indirectNarrow), R the mean of the maps by weight.
// samples: directions from the maps, each with one from the BSDF if that has a glossy lobe or the map is turned away
// from the surface (balance heuristic). Sample s of pixel `stream` has the index firstIndex + s, so that passes
// continue one sequence. `sites` must not be empty.
Rgb gather(const PrimaryHit& hit, const LobeMask& lobes, std::span<const WeightedSite> sites, int samples,
           uint64_t stream, uint32_t firstIndex);

}  // namespace drc
