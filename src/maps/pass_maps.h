// The radiance maps of one map pass, and the choice of the maps that a pixel uses: the four at the corners of the
// pixel's grid cell, and nearby additional maps, placed where the grid's maps do not suffice. The film is processed in
// bands from top to bottom, so that only the maps of a few bands are in memory at a time, whatever the size of the
// pass.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "maps/gather.h"
#include "maps/map_grid.h"

namespace drc {

class PassMaps {
  public:
    // margin: largest distance, in pixels, of a camera sample from its pixel's centre (the filter's radius). bandMaps:
    // least number of grid maps per band.
    PassMaps(const MapGrid& grid, const PixelRegion& region, float margin,
             Interpolation interpolation = Interpolation::Geometry, int bandMaps = kBandMaps);

    // Pixels use only maps of their own band and of the band above, and additional maps of the band below. A band can
    // therefore be gathered once the maps of the next band are complete, and released once the next band is gathered.
    int bandCount() const { return int(bands_.size()); }
    PixelRegion pixels(int band) const;

    // Add the sites of a band's maps, whose film position and radius are set; the caller captures the maps. Level 0 is
    // the grid. Each further level holds maps around the given film positions, with a radius of influence of `radius`
    // pixels; the positions must be those of camera samples of the band's pixels. The spans are valid until the next
    // addLevel() or release() of the band.
    std::span<MapSite> addGrid(int band);
    // Number of grid points in this band and all bands above it.
    int pointsThrough(int band) const { return band + 1 == bandCount() ? grid_.count() : firstPoint(band + 1); }
    std::span<MapSite> addLevel(int band, float radius, std::span<const Vec2> points);
    // Frees the band's maps.
    void release(int band) { bands_[size_t(band)] = {}; }

    // Sum of the weights of a level's maps for a camera sample of the band; 0 if the sample can use none of them.
    float coverage(int band, const PixelSite& pixel, size_t level) const;
    // Sets `result` to the maps of all levels with a positive weight for a camera sample. If their weights sum to less
    // than `least`, the maps are weighted again by relaxedWeight(), which admits maps off the pixel's tangent plane. If
    // the sum is still below `least`, `result` is empty.
    void findAround(int band, const PixelSite& pixel, float least, std::vector<WeightedSite>& result) const;

    // Enough maps to keep many cores busy, and few enough to keep in memory.
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
    // A band contains the rows of grid cells from firstRow(band) up to, but not including, firstRow(band + 1), and the
    // points at their lower corners. The first band also contains the topmost row of points.
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
    std::vector<int> bandOfRow_;  // the band that contains each row of grid points
};

// Chooses film positions for at most `most` additional maps. Divides the region into blocks of about `radius` pixels,
// and picks, from each block with a sufficient share of `lacking` pixels, the lacking pixel with the lowest `order`;
// blocks with the most lacking pixels come first. lacking, order, film: functions of a pixel (x, y); `film` gives the
// position of the pixel's camera sample.
std::vector<Vec2> fillPoints(const PixelRegion& region, float radius, size_t most,
                             const std::function<bool(int x, int y)>& lacking,
                             const std::function<uint64_t(int x, int y)>& order,
                             const std::function<Vec2(int x, int y)>& film);

}  // namespace drc
