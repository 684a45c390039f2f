// The share of light that leaves a scattering half-space below a smooth dielectric boundary, summed over all exit
// points.
#pragma once
#include <memory>
#include <vector>

#include "math/catmull_rom.h"

namespace drc {

// The medium is homogeneous and infinitely deep, with the phase function of Henyey and Greenstein. The boundary
// reflects light from inside back into the medium, totally beyond the critical angle. The light enters uniformly from
// all directions outside.
//
// The share is computed by the adding-doubling method (van de Hulst, "Multiple Light Scattering", 1980; Prahl, "The
// Adding-Doubling Method", 1995) and tabulated over the albedo of single scattering. Its only error is the finite
// number of directions. The diffusion approximation, in contrast, is wrong where light is absorbed before it has been
// scattered often.
class HalfSpaceAlbedo {
  public:
    // g: mean cosine of the phase function, in (-1, 1); eta: relative index of refraction of the medium, at least 1.
    HalfSpaceAlbedo(float g, float eta);

    // Share of the entered light that leaves again. scattering: albedo of single scattering, in [0, 1].
    float operator()(float scattering) const;

  private:
    float g_;
    // The nodes are spaced in sqrt((1 - albedo) / (1 - g albedo)), the similarity parameter, in which the share is
    // nearly linear.
    SplineNodes nodes_;
    std::vector<float> shares_;
};

// Computing a table takes some milliseconds, so callers with equal g and eta share one, which lives as long as any of
// them holds it. Safe to call from several threads.
std::shared_ptr<const HalfSpaceAlbedo> halfSpaceAlbedo(float g, float eta);

}  // namespace drc
