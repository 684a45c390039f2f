// The maps of one pass, and which of them serve a pixel: those at the corners of its cell of the grid, and those that
// fill in around it where the grid's do not.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "cache/gather.h"
#include "cache/map_grid.h"

namespace drc {

class PassMaps {
  public:
    explicit PassMaps(const MapGrid& grid, Interpolation interpolation = Interpolation::Geometry);

    // Level 0 is the grid; each further one holds maps that reach `radius` pixels about the given points of the film.
    // Sites have their film position and reach; the caller captures their maps. A span is good until the next addLevel.
    std::span<MapSite> grid() { return gridSites_; }
    std::span<MapSite> addLevel(const PixelRegion& region, float radius, std::span<const Vec2> points);

    // Sum of the weights of a level's maps for a pixel: 0 where none serves it.
    float coverage(const PixelSite& pixel, size_t level) const;
    // The maps of all levels that serve a pixel, all weights > 0. Where their weights' sum is below `least`, those that
    // stand aside serve as well, for want of better ones; empty, where these do not reach it either.
    void findAround(const PixelSite& pixel, float least, std::vector<WeightedSite>& result) const;

  private:
    using Weight = float (*)(const PixelSite&, const MapSite&);
    struct Fill {
        std::vector<MapSite> sites;
        FilmBuckets buckets;
        float radius;
    };
    Weight weight() const;
    template <typename F>
    void forEachOfLevel(size_t level, const PixelSite& pixel, Weight geometry, F&& f) const;

    MapGrid grid_;
    Interpolation interpolation_;
    std::vector<MapSite> gridSites_;
    std::vector<Fill> fills_;
};

// Where a level of maps fills in: of each block of about `radius` pixels in which a fair share of the pixels is
// `lacking`, the one of them whose `order` is least; at most `most` points, those of the blocks that lack most first.
// lacking, order, film: functions of a pixel (x, y).
std::vector<Vec2> fillPoints(const PixelRegion& region, float radius, size_t most,
                             const std::function<bool(int x, int y)>& lacking,
                             const std::function<uint64_t(int x, int y)>& order,
                             const std::function<Vec2(int x, int y)>& film);

}  // namespace drc
