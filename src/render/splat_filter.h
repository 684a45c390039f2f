// Adds light that lands anywhere on the film, not in the pixel that asked for it: what paths from the lights bring to
// the lens. Each splat counts for all pixels whose filter reaches it.
#pragma once
#include "integrators/bdpt.h"
#include "render/film_layer.h"

namespace drc {

class SplatFilter {
  public:
    // The filter must outlive this.
    explicit SplatFilter(const Filter& filter);
    // To an exact layer without weights. From any thread; the sums do not depend on the order.
    void add(const Splat& splat, FilmLayer& layer) const;

  private:
    const Filter& filter_;
    float scale_;  // makes the filter's integral 1
};

}  // namespace drc
