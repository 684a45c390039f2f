// The maps of one pass, and which of them serve a pixel: those at the corners of its cell of the grid, and those that
// fill in around it where the grid's do not. They come in bands of the film from top to bottom, so that no more than a
// few bands' maps need to be in memory, however many the pass has.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "cache/gather.h"
#include "cache/map_grid.h"

namespace drc {

class PassMaps {
  public:
    // margin: how far from its pixel's centre a camera sample may lie on the film, in pixels (the filter's radius).
    // bandMaps: of the grid, that a band should have at least.
    PassMaps(const MapGrid& grid, const PixelRegion& region, float margin,
             Interpolation interpolation = Interpolation::Geometry, int bandMaps = kBandMaps);

    // Pixels of a band are served by its maps, those of the band above and those that fill in in the band below, and by
    // no others: whatever the pass, a band can be gathered when the next one is whole, and be released after that one.
    int bandCount() const { return int(bands_.size()); }
    PixelRegion pixels(int band) const;

    // Level 0 is the grid; each further one holds maps that reach `radius` pixels about the given points of the film,
    // which are those of samples of the band's pixels. Sites have their film position and reach; the caller captures
    // their maps. Spans are good until the band's next addLevel, or its release.
    std::span<MapSite> addGrid(int band);
    // Points of the grid in this band and those above it.
    int pointsThrough(int band) const { return band + 1 == bandCount() ? grid_.count() : firstPoint(band + 1); }
    std::span<MapSite> addLevel(int band, float radius, std::span<const Vec2> points);
    // Forgets the band's maps.
    void release(int band) { bands_[size_t(band)] = {}; }

    // Sum of the weights of a level's maps for a sample of the band's pixels: 0 where none serves it.
    float coverage(int band, const PixelSite& pixel, size_t level) const;
    // The maps of all levels that serve it, all weights > 0. Where their weights' sum is below `least`, those that
    // stand aside serve as well, for want of better ones; empty, where these do not reach it either.
    void findAround(int band, const PixelSite& pixel, float least, std::vector<WeightedSite>& result) const;

    // Enough to keep many cores busy, and few to keep.
    static constexpr int kBandMaps = 256;

  private:
    using Weight = float (*)(const PixelSite&, const MapSite&);
    struct Fill {
        std::vector<MapSite> sites;
        FilmBuckets buckets;
        float radius;
    };
    struct Band {
        std::vector<MapSite> grid;
        std::vector<Fill> fills;
    };
    Weight weight() const;
    // A band has the grid's cells of the rows from firstRow(band) to before firstRow(band + 1), and the points below
    // them; the first band also those above.
    int firstRow(int band) const;
    int firstPoint(int band) const { return band == 0 ? 0 : (firstRow(band) + 1) * grid_.columns(); }
    int firstPixelRow(int band) const;
    const MapSite& gridSite(int row, int column) const;
    template <typename F>
    void forEachOfLevel(int band, size_t level, const PixelSite& pixel, Weight geometry, F&& f) const;

    MapGrid grid_;
    PixelRegion region_;
    float margin_;
    Interpolation interpolation_;
    std::vector<Band> bands_;
    std::vector<int> bandOfRow_;  // of the grid's points
};

// Where a level of maps fills in: of each block of about `radius` pixels in which a fair share of the pixels is
// `lacking`, the one of them whose `order` is least; at most `most` points, those of the blocks that lack most first.
// lacking, order, film: functions of a pixel (x, y).
std::vector<Vec2> fillPoints(const PixelRegion& region, float radius, size_t most,
                             const std::function<bool(int x, int y)>& lacking,
                             const std::function<uint64_t(int x, int y)>& order,
                             const std::function<Vec2(int x, int y)>& film);

}  // namespace drc
