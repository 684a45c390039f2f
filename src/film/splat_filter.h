// Adds the splats of light paths, which may land anywhere on the film, to all pixels whose filter support contains
// their position.
#pragma once
#include "film/film_layer.h"
#include "transport/bdpt.h"

namespace drc {

class SplatFilter {
  public:
    // The filter must outlive this object.
    explicit SplatFilter(const Filter& filter);
    // Adds a splat to an exact layer without weights. Any thread may call it; the sums do not depend on the order.
    void add(const Splat& splat, FilmLayer& layer) const;

  private:
    const Filter& filter_;
    float scale_;  // 1 / integral of the filter
};

}  // namespace drc
