// Tables for sampling an environment over the rectified coordinates of a Portal. Portals with the same frame can share
// them.
#pragma once
#include <memory>

#include "math/distribution.h"
#include "math/windowed_distribution.h"
#include "scene/lights/light.h"
#include "scene/lights/portal.h"

namespace drc {

class RectifiedEnvironment {
  public:
    // rows: rows of the environment's map; 1 for a constant environment. The tables have about as many cells along a
    // side, but at most about mostCells, and fewer where that hardly increases the variance (coarsestCell).
    RectifiedEnvironment(const Light& environment, int rows, const Portal& portal, int mostCells = 1024);

    // Distributions over rectified coordinates: of radiance, for points behind the portal (seen); and of radiance times
    // cosine, for paths that start at the portal (entering).
    const WindowedDistribution2D& seen() const { return seen_; }
    const Distribution2D& entering() const { return entering_; }
    // Flux that enters, per area of the portal.
    const Rgb& fluxPerArea() const { return flux_; }

  private:
    WindowedDistribution2D seen_;
    Distribution2D entering_;
    Rgb flux_{0.f};
};

}  // namespace drc
