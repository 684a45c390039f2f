#include "maps/pass_maps.h"

#include <algorithm>

namespace drc {
namespace {

// The least share of a block's pixels that must lack maps before the block gets one. Below it, the pixels are left to
// the path-traced fallback, because a map costs as much as a thousand paths.
constexpr float kFillShare = 0.1f;

}  // namespace

PassMaps::PassMaps(const MapGrid& grid, const PixelRegion& region, float margin, Interpolation interpolation,
                   int bandMaps)
    : grid_(grid), region_(region), margin_(margin), interpolation_(interpolation) {
    // A map that a pixel uses is away from it by at most a grid cell plus the sampling margins of two pixels. Bands of
    // at least that height ensure that the map is in the same or an adjacent band.
    const int cellRows = grid.rows() - 1, leastRows = 1 + int(std::ceil(2 * margin / grid.spacing()));
    bands_.resize(size_t(std::max(1, std::min(grid.count() / std::max(1, bandMaps), cellRows / leastRows))));
    bandOfRow_.resize(size_t(grid.rows()));
    for (int band = 0; band < bandCount(); ++band)
        std::fill(bandOfRow_.begin() + firstPoint(band) / grid.columns(), bandOfRow_.end(), band);
}

int PassMaps::firstRow(int band) const { return int(int64_t(grid_.rows() - 1) * band / bandCount()); }

// A band begins at the first pixel row whose samples may fall below the band's first row of grid points.
int PassMaps::firstPixelRow(int band) const {
    if (band == 0) return region_.y0;
    if (band == bandCount()) return region_.y1;
    const float last = grid_.rowAt(firstRow(band)) - 0.5f - margin_ - 0.01f;
    return std::clamp(int(std::floor(last)) + 1, region_.y0, region_.y1);
}

PixelRegion PassMaps::pixels(int band) const {
    return {region_.x0, firstPixelRow(band), region_.x1, firstPixelRow(band + 1)};
}

std::span<MapSite> PassMaps::addGrid(int band) {
    const int first = firstPoint(band), end = pointsThrough(band);
    std::vector<MapSite>& sites = bands_[size_t(band)].grid;
    sites.resize(size_t(end - first));
    for (int i = first; i < end; ++i) {
        MapSite& site = sites[size_t(i - first)];
        site.film = grid_.point(i);
        site.radius = grid_.spacing();
    }
    return sites;
}

std::span<MapSite> PassMaps::addLevel(int band, float radius, std::span<const Vec2> points) {
    Fill& fill = bands_[size_t(band)].fills.emplace_back(Fill{{}, FilmBuckets(pixels(band), radius), radius});
    fill.sites.resize(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        fill.sites[i].film = points[i];
        fill.sites[i].radius = radius;
        fill.buckets.add(points[i], int(i));
    }
    return fill.sites;
}

const MapSite& PassMaps::gridSite(int row, int column) const {
    const int band = bandOfRow_[size_t(row)];
    return bands_[size_t(band)].grid[size_t(row * grid_.columns() + column - firstPoint(band))];
}

PassMaps::Weight PassMaps::weight() const {
    return interpolation_ == Interpolation::Distance ? presentWeight : geometryWeight;
}

template <typename F>
void PassMaps::forEachOfLevel(int band, size_t level, const PixelSite& pixel, Weight geometry, F&& f) const {
    const auto visit = [&](const MapSite& site, float falloff) {
        const float w = falloff > 0 ? falloff * geometry(pixel, site) : 0;
        if (w > 0) f(site, w);
    };
    if (level == 0) {
        const int corner = grid_.cell(pixel.film), row = corner / grid_.columns(), column = corner % grid_.columns();
        for (const int y : {row, row + 1})
            for (const int x : {column, column + 1}) {
                const MapSite& site = gridSite(y, x);
                visit(site, tentWeight(pixel.film, site.film, grid_.spacing()));
            }
        return;
    }
    for (int near = std::max(0, band - 1); near <= std::min(band + 1, bandCount() - 1); ++near) {
        const std::vector<Fill>& fills = bands_[size_t(near)].fills;
        if (level > fills.size()) continue;
        const Fill& fill = fills[level - 1];
        fill.buckets.forEachNear(pixel.film, [&](int id) {
            const MapSite& site = fill.sites[size_t(id)];
            visit(site, radialWeight(pixel.film, site.film, fill.radius));
        });
    }
}

float PassMaps::coverage(int band, const PixelSite& pixel, size_t level) const {
    float sum = 0;
    forEachOfLevel(band, level, pixel, weight(), [&](const MapSite&, float w) { sum += w; });
    return sum;
}

void PassMaps::findAround(int band, const PixelSite& pixel, float least, std::vector<WeightedSite>& result) const {
    size_t levels = 0;
    for (int near = std::max(0, band - 1); near <= std::min(band + 1, bandCount() - 1); ++near)
        levels = std::max(levels, bands_[size_t(near)].fills.size());
    for (const Weight geometry : {weight(), Weight(relaxedWeight)}) {
        result.clear();
        float sum = 0;
        for (size_t level = 0; level <= levels; ++level)
            forEachOfLevel(band, level, pixel, geometry, [&](const MapSite& site, float w) {
                result.push_back({&site, w});
                sum += w;
            });
        if (sum >= least) return;
    }
    result.clear();
}

std::vector<Vec2> fillPoints(const PixelRegion& region, float radius, size_t most,
                             const std::function<bool(int, int)>& lacking,
                             const std::function<uint64_t(int, int)>& order,
                             const std::function<Vec2(int, int)>& film) {
    const int block = std::max(2, int(radius));
    struct Block {
        Vec2 film{0.f};
        int lacking = 0;
    };
    std::vector<Block> blocks;
    for (int by = region.y0; by < region.y1; by += block)
        for (int bx = region.x0; bx < region.x1; bx += block) {
            Block here;
            uint64_t best = ~uint64_t(0);
            for (int y = by; y < std::min(by + block, region.y1); ++y)
                for (int x = bx; x < std::min(bx + block, region.x1); ++x) {
                    if (!lacking(x, y)) continue;
                    ++here.lacking;
                    if (const uint64_t o = order(x, y); o < best) {
                        best = o;
                        here.film = film(x, y);
                    }
                }
            if (here.lacking > 0 && float(here.lacking) >= kFillShare * float(block * block)) blocks.push_back(here);
        }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Block& a, const Block& b) { return a.lacking > b.lacking; });
    std::vector<Vec2> points;
    for (size_t i = 0; i < std::min(most, blocks.size()); ++i) points.push_back(blocks[i].film);
    return points;
}

}  // namespace drc
