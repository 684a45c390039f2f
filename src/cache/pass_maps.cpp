#include "cache/pass_maps.h"

#include <algorithm>

namespace drc {
namespace {

// Blocks in which fewer than this share of the pixels lack maps are left to the fallback: a map costs a thousand paths.
constexpr float kFillShare = 0.1f;

}  // namespace

PassMaps::PassMaps(const MapGrid& grid, Interpolation interpolation)
    : grid_(grid), interpolation_(interpolation), gridSites_(size_t(grid.count())) {
    for (int i = 0; i < grid.count(); ++i) {
        gridSites_[size_t(i)].film = grid.point(i);
        gridSites_[size_t(i)].radius = grid.spacing();
    }
}

std::span<MapSite> PassMaps::addLevel(const PixelRegion& region, float radius, std::span<const Vec2> points) {
    Fill& fill = fills_.emplace_back(Fill{{}, FilmBuckets(region, radius), radius});
    fill.sites.resize(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        fill.sites[i].film = points[i];
        fill.sites[i].radius = radius;
        fill.buckets.add(points[i], int(i));
    }
    return fill.sites;
}

PassMaps::Weight PassMaps::weight() const {
    return interpolation_ == Interpolation::Distance ? presentWeight : geometryWeight;
}

template <typename F>
void PassMaps::forEachOfLevel(size_t level, const PixelSite& pixel, Weight geometry, F&& f) const {
    const auto visit = [&](const MapSite& site, float falloff) {
        const float w = falloff > 0 ? falloff * geometry(pixel, site) : 0;
        if (w > 0) f(site, w);
    };
    if (level == 0) {
        const int corner = grid_.cell(pixel.film);
        for (const int i : {corner, corner + 1, corner + grid_.columns(), corner + grid_.columns() + 1}) {
            const MapSite& site = gridSites_[size_t(i)];
            visit(site, tentWeight(pixel.film, site.film, grid_.spacing()));
        }
        return;
    }
    const Fill& fill = fills_[level - 1];
    fill.buckets.forEachNear(pixel.film, [&](int id) {
        const MapSite& site = fill.sites[size_t(id)];
        visit(site, radialWeight(pixel.film, site.film, fill.radius));
    });
}

float PassMaps::coverage(const PixelSite& pixel, size_t level) const {
    float sum = 0;
    forEachOfLevel(level, pixel, weight(), [&](const MapSite&, float w) { sum += w; });
    return sum;
}

void PassMaps::findAround(const PixelSite& pixel, float least, std::vector<WeightedSite>& result) const {
    for (const Weight geometry : {weight(), Weight(relaxedWeight)}) {
        result.clear();
        float sum = 0;
        for (size_t level = 0; level <= fills_.size(); ++level)
            forEachOfLevel(level, pixel, geometry, [&](const MapSite& site, float w) {
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
