// Adds light paths' contributions, which may land anywhere on the film, to all pixels whose filter reaches their
// position.
#pragma once
#include "film/film_layer.h"
#include "transport/bdpt.h"

namespace drc {

class SplatFilter {
  public:
    // The filter must outlive this object.
    explicit SplatFilter(const Filter& filter);
    // Adds a splat to an exact layer without weights. From any thread; the sums do not depend on the order.
    void add(const Splat& splat, FilmLayer& layer) const;

  private:
    const Filter& filter_;
    float scale_;  // normalises the filter's integral to 1
};

}  // namespace drc
