#include "film/splat_filter.h"

namespace drc {
namespace {

double integral(const Filter& filter) {
    constexpr int kSide = 256;
    const Vec2 radius = filter.radius();
    double sum = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const Vec2 at((2 * (float(i) + 0.5f) / kSide - 1) * radius.x,
                          (2 * (float(j) + 0.5f) / kSide - 1) * radius.y);
            sum += double(filter.eval(at));
        }
    return sum * 4 * double(radius.x) * double(radius.y) / (double(kSide) * kSide);
}

}  // namespace

SplatFilter::SplatFilter(const Filter& filter) : filter_(filter), scale_(float(1 / integral(filter))) {}

void SplatFilter::add(const Splat& splat, FilmLayer& layer) const {
    // Pixel centres have half-integer coordinates.
    const Vec2 at(splat.film.x - 0.5f, splat.film.y - 0.5f), radius = filter_.radius();
    if (!(std::abs(at.x) < 1e9f && std::abs(at.y) < 1e9f)) return;
    const PixelRegion& region = layer.region();
    const int x0 = std::max(region.x0, int(std::ceil(at.x - radius.x)));
    const int x1 = std::min(region.x1 - 1, int(std::floor(at.x + radius.x)));
    const int y0 = std::max(region.y0, int(std::ceil(at.y - radius.y)));
    const int y1 = std::min(region.y1 - 1, int(std::floor(at.y + radius.y)));
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            layer.splat(x, y, splat.radiance * (scale_ * filter_.eval(Vec2(at.x - float(x), at.y - float(y)))));
}

}  // namespace drc
