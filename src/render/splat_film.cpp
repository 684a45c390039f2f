#include "render/splat_film.h"

#include "base/parallel.h"

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

SplatFilm::SplatFilm(const PixelRegion& region, const Filter& filter)
    : region_(region), filter_(&filter), scale_(float(1 / integral(filter))), sums_(3 * region.count()) {}

void SplatFilm::add(std::span<const Catch> catches) {
    for (const Catch& c : catches) paths_ += c.paths;
    const Vec2 radius = filter_->radius();
    constexpr int kRows = 16;
    parallelFor(region_.y0, region_.y1, kRows, [&](int begin, int end) {
        for (const Catch& c : catches)
            for (const Splat& splat : c.splats) {
                // Pixels' centres are at halves.
                const Vec2 at(splat.film.x - 0.5f, splat.film.y - 0.5f);
                if (!(std::abs(at.x) < 1e9f && std::abs(at.y) < 1e9f)) continue;
                const int x0 = std::max(region_.x0, int(std::ceil(at.x - radius.x)));
                const int x1 = std::min(region_.x1 - 1, int(std::floor(at.x + radius.x)));
                const int y0 = std::max(begin, int(std::ceil(at.y - radius.y)));
                const int y1 = std::min(end - 1, int(std::floor(at.y + radius.y)));
                for (int y = y0; y <= y1; ++y)
                    for (int x = x0; x <= x1; ++x) {
                        const float f = scale_ * filter_->eval(Vec2(at.x - float(x), at.y - float(y)));
                        double* sum = &sums_[3 * region_.index(x, y)];
                        for (int k = 0; k < 3; ++k) sum[k] += double(f) * double(splat.radiance[k]);
                    }
            }
    });
}

Rgb SplatFilm::value(int x, int y) const {
    if (paths_ == 0) return Rgb(0.f);
    const double* sum = &sums_[3 * region_.index(x, y)];
    const double scale = double(region_.count()) / double(paths_);
    return Rgb(float(sum[0] * scale), float(sum[1] * scale), float(sum[2] * scale));
}

}  // namespace drc
