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

// Pixels whose filter a splat reaches: y0 to y1 and x0 to x1, borders included; none if an end is before its start.
// Pixels' centres are at halves.
SplatFilm::Reach SplatFilm::reach(const Splat& splat) const {
    const Vec2 at(splat.film.x - 0.5f, splat.film.y - 0.5f);
    if (!(std::abs(at.x) < 1e9f && std::abs(at.y) < 1e9f)) return {};
    const Vec2 radius = filter_->radius();
    return {at, std::max(region_.x0, int(std::ceil(at.x - radius.x))),
            std::min(region_.x1 - 1, int(std::floor(at.x + radius.x))),
            std::max(region_.y0, int(std::ceil(at.y - radius.y))),
            std::min(region_.y1 - 1, int(std::floor(at.y + radius.y)))};
}

// A counting sort: each band's splats in the order given, which is that of the sums of each pixel.
SplatFilm::Bands SplatFilm::sortIntoBands(std::span<const Catch> catches) const {
    const auto bandOf = [&](int y) { return size_t((y - region_.y0) / kRows); };
    const auto forEachBand = [&](auto&& visit) {
        for (const Catch& c : catches)
            for (const Splat& splat : c.splats) {
                const Reach r = reach(splat);
                if (r.x0 > r.x1 || r.y0 > r.y1) continue;
                for (size_t band = bandOf(r.y0); band <= bandOf(r.y1); ++band) visit(band, splat);
            }
    };
    Bands bands;
    bands.begin.resize(size_t(region_.height() + kRows - 1) / kRows + 1);
    forEachBand([&](size_t band, const Splat&) { ++bands.begin[band + 1]; });
    std::partial_sum(bands.begin.begin(), bands.begin.end(), bands.begin.begin());
    bands.splats.resize(bands.begin.back());
    std::vector<size_t> next = bands.begin;
    forEachBand([&](size_t band, const Splat& splat) { bands.splats[next[band]++] = &splat; });
    return bands;
}

void SplatFilm::add(std::span<const Catch> catches) {
    for (const Catch& c : catches) paths_ += c.paths;
    const Bands bands = sortIntoBands(catches);
    visits_ += bands.splats.size();
    parallelFor(region_.y0, region_.y1, kRows, [&](int begin, int end) {
        const auto band = size_t((begin - region_.y0) / kRows);
        for (size_t i = bands.begin[band]; i < bands.begin[band + 1]; ++i) {
            const Splat& splat = *bands.splats[i];
            const Reach r = reach(splat);
            for (int y = std::max(r.y0, begin); y <= std::min(r.y1, end - 1); ++y)
                for (int x = r.x0; x <= r.x1; ++x) {
                    const float f = scale_ * filter_->eval(Vec2(r.at.x - float(x), r.at.y - float(y)));
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
