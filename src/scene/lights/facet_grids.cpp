#include "scene/lights/facet_grids.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// Number of cells along a vector of texture coordinates: its length in texels, minus 0.01 for rounding errors, rounded
// up.
int cellsAlong(const Vec2& uv, const EmissionImage& image) {
    const float texels = std::hypot(uv.x * float(image.width()), uv.y * float(image.height()));
    return texels > 1 ? int(std::min(std::ceil(texels - 0.01f), 65536.f)) : 1;
}

}  // namespace

FacetEmission FacetGrids::of(const EmissionImage& image, const FacetCoordinates& facet) {
    const Key key = {facet.corner.x, facet.corner.y, facet.side0.x,         facet.side0.y,
                     facet.side1.x,  facet.side1.y,  facet.half ? 1.f : 0.f};
    const bool isUsable = std::ranges::all_of(key, [](float x) { return std::isfinite(x); });
    int64_t most = 0;
    {
        const std::lock_guard lock(mutex_);
        if (const auto known = known_.find(key); isUsable && known != known_.end()) return known->second;
        most = std::clamp<int64_t>((kMostCells - cells_) / 16, kLeastCells, EmissionGrid::kMostCells);
    }
    int columns = cellsAlong(facet.side0, image), rows = cellsAlong(facet.side1, image);
    if (facet.half) {
        // On a triangle, the columns run from the corner to the opposite side, and the rows along that side.
        columns = std::max(columns, rows);
        rows = cellsAlong(facet.side1 - facet.side0, image);
    }
    const auto grid = std::make_shared<const EmissionGrid>(
        image, columns, rows, [&facet](const Vec2& at) { return PatchPoint{facet.at(pointOnFacet(at, facet.half))}; },
        int(most));
    FacetEmission emission{grid->integral(), float(grid->weight()), nullptr};
    if (grid->isUniform() || !isUsable) return emission;
    emission.grid = grid;
    const std::lock_guard lock(mutex_);
    cells_ += grid->cellCount();
    return known_.try_emplace(key, emission).first->second;
}

}  // namespace drc
