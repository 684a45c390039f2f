// The radiance maps of one map pass, and which of them serve a pixel: the four at the corners of the grid cell that the
// pixel lies in, and additional maps nearby, placed where the grid's maps do not serve. The film is processed in bands
// from top to bottom, so that only the maps of a few bands are in memory at a time, however many the pass has.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "maps/gather.h"
#include "maps/map_grid.h"

namespace drc {

class PassMaps {
  public:
    // margin: largest distance on the film of a camera sample from its pixel's centre, in pixels (the filter's radius).
    // bandMaps: number of grid maps that a band should have at least.
    PassMaps(const MapGrid& grid, const PixelRegion& region, float margin,
             Interpolation interpolation = Interpolation::Geometry, int bandMaps = kBandMaps);

    // The pixels of a band use only the band's own maps, those of the band above, and the additional maps of the band
    // below. A band can therefore be gathered once the next band's maps are complete, and released once the next band
    // has been gathered.
    int bandCount() const { return int(bands_.size()); }
    PixelRegion pixels(int band) const;

    // Level 0 is the grid. Each further level holds maps with a radius of influence of `radius` pixels around the given
    // film positions, which must be those of samples of the band's pixels. The sites returned have their film position
    // and radius set; the caller captures their maps. The spans are valid until the next addLevel() of the band or its
    // release().
    std::span<MapSite> addGrid(int band);
    // Number of grid points in this band and all bands above it.
    int pointsThrough(int band) const { return band + 1 == bandCount() ? grid_.count() : firstPoint(band + 1); }
    std::span<MapSite> addLevel(int band, float radius, std::span<const Vec2> points);
    // Frees the band's maps.
    void release(int band) { bands_[size_t(band)] = {}; }

    // Sum of the weights of a level's maps for a sample of one of the band's pixels; 0 if none serves it.
    float coverage(int band, const PixelSite& pixel, size_t level) const;
    // Sets `result` to the maps of all levels that serve a sample, with weights > 0. If the sum of the weights is below
    // `least`, the maps are weighted anew by relaxedWeight(), which admits maps off the pixel's tangent plane. If that
    // does not reach `least` either, `result` is empty.
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
    // A band owns the rows of grid cells from firstRow(band) up to, but not including, firstRow(band + 1), and the
    // points at their lower corners. The first band also owns the topmost row of points.
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
    std::vector<int> bandOfRow_;  // the band that owns each row of grid points
};

// Where to place additional maps. Divides the region into blocks of about `radius` pixels, and chooses from each block
// with a sufficient share of `lacking` pixels the lacking pixel with the lowest `order`. Returns the film positions of
// at most `most` pixels, those of the blocks with most lacking pixels first. lacking, order, film: functions of a pixel
// (x, y); `film` gives the position of the pixel's sample.
std::vector<Vec2> fillPoints(const PixelRegion& region, float radius, size_t most,
                             const std::function<bool(int x, int y)>& lacking,
                             const std::function<uint64_t(int x, int y)>& order,
                             const std::function<Vec2(int x, int y)>& film);

}  // namespace drc
