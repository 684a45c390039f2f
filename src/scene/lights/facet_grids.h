// Tables for sampling an emission image on the flat facets of meshes. Facets with the same texture coordinates, such as
// the windows of a facade, share one table.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <mutex>

#include "scene/lights/emission_grid.h"
#include "scene/lights/facet.h"

namespace drc {

// The emission of a facet, averaged over its area, before multiplication by Emission::scale().
struct FacetEmission {
    Rgb mean{0.f};
    float weight = 0;                          // EmissionGrid::weight()
    std::shared_ptr<const EmissionGrid> grid;  // over the square of pointOnFacet(); null: sampled uniformly
};

class FacetGrids {
  public:
    FacetEmission of(const EmissionImage& image, const FacetCoordinates& facet);

  private:
    using Key = std::array<float, 7>;
    // Cells of all tables of an image together; once they are used up, each new table gets kLeastCells.
    static constexpr int64_t kMostCells = 1 << 24, kLeastCells = 1 << 8;

    std::mutex mutex_;
    std::map<Key, FacetEmission> known_;  // facets with a table
    int64_t cells_ = 0;
};

}  // namespace drc
