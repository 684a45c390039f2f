// Tables of an environment in the rectified coordinates of portals that face the same way (Portal).
#pragma once
#include <memory>

#include "math/distribution.h"
#include "math/windowed_distribution.h"
#include "scene/lights/light.h"
#include "scene/lights/portal.h"

namespace drc {

class RectifiedEnvironment {
  public:
    // rows: of the environment's map, 1 for a constant one. The tables have about as many cells along a side, but at
    // most mostCells, and fewer where that costs next to nothing (coarsestCell).
    RectifiedEnvironment(const Light& environment, int rows, const Portal& portal, int mostCells = 1024);

    // Over rectified coordinates: radiance, as points behind the portal see it; and radiance times cosine, as it
    // enters.
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
