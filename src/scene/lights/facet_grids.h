// Where on the flat facets of emissive meshes to sample an image of emission. Facets with the same texture coordinates,
// such as the windows of a facade, share one table.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <mutex>

#include "scene/lights/emission_grid.h"
#include "scene/lights/facet.h"

namespace drc {

// The emission of a facet, per unit of area and before Emission::scale().
struct FacetEmission {
    Rgb mean{0.f};
    float weight = 0;                          // EmissionGrid::weight()
    std::shared_ptr<const EmissionGrid> grid;  // over the square of pointOnFacet(); null: points are sampled uniformly
};

class FacetGrids {
  public:
    FacetEmission of(const EmissionImage& image, const FacetCoordinates& facet);

  private:
    using Key = std::array<float, 7>;
    // All tables of an image together; beyond it new ones are small.
    static constexpr int64_t kMostCells = 1 << 24, kLeastCells = 1 << 8;

    std::mutex mutex_;
    std::map<Key, FacetEmission> known_;  // those with a table
    int64_t cells_ = 0;
};

}  // namespace drc
