// How much light comes back out of a scattering medium below a smooth dielectric boundary, wherever it comes out.
#pragma once
#include <memory>
#include <vector>

#include "math/catmull_rom.h"

namespace drc {

// The medium is homogeneous and infinitely deep, with the phase function of Henyey and Greenstein. The boundary
// reflects light inside back, totally beyond the critical angle. The light that has entered comes from all directions
// outside.
//
// Found by the adding-doubling method (van de Hulst, "Multiple Light Scattering", 1980; Prahl, "The Adding-Doubling
// Method", 1995), once for all albedos of single scattering. It is exact but for the number of directions; diffusion,
// on the other hand, is wrong where light is absorbed before it has been scattered often.
class HalfSpaceAlbedo {
  public:
    // g: mean cosine of the phase function, in (-1, 1); eta: relative index of refraction of the medium, at least 1.
    HalfSpaceAlbedo(float g, float eta);

    // Share of the light that has entered that leaves again. scattering: albedo of single scattering, in [0, 1].
    float operator()(float scattering) const;

  private:
    float g_;
    // The share is nearly linear in sqrt((1 - albedo) / (1 - g albedo)), which similar media have in common.
    SplineNodes nodes_;
    std::vector<float> shares_;
};

// Finding a table takes some milliseconds, so callers with equal g and eta share one, which lives as long as any of
// them holds it. Safe to call from several threads.
std::shared_ptr<const HalfSpaceAlbedo> halfSpaceAlbedo(float g, float eta);

}  // namespace drc
