#include "render/correction.h"

#include <algorithm>

#include "base/parallel.h"
#include "render/surface_filter.h"

namespace drc {
namespace {

// The difference is looked at in pixels and in four averages of it, of standard deviations 1, 2.2, 4.6 and 9.2 pixels.
constexpr int kLevels = 5;
constexpr float kSmallestAlbedo = 0.02f;
// Times the variance that counts as noise. One would give the least mean square error of Gaussian noise; more gives a
// calmer picture, and above two a bright path that only one group met counts as noise however bright it is (its square
// over the variance is one), and does not become a blotch.
constexpr float kCaution = 2.5f;

// Sum of the weights of a pixel's neighbours on its surface, of which its own is 0.14: with less than the first it
// stands alone, as where it shows an edge, a mixture of two surfaces, and the few paths of its own are no statistics;
// those that miss a bright spot agree with each other. With more than the second there are enough.
constexpr float kAlone = 0.15f, kAmongEnough = 0.4f;

// Of a difference: its square, and the sum of many, are still numbers.
constexpr float kLargest = 1e15f;

constexpr int kGroups = IndirectCorrection::kGroups;

// f(pixel), in parallel.
template <typename F>
void forEachPixel(size_t count, const F& f) {
    constexpr int kGrain = 1 << 14;
    parallelFor(0, int(count), kGrain, [&](int begin, int end) {
        for (auto i = size_t(begin); i < size_t(end); ++i) f(i);
    });
}

// The mean of the independent groups in the first three planes, and its variance in the other three. groups: three
// planes of each group, one after the other.
Planes estimates(const Planes& groups, size_t pixels) {
    Planes result(pixels, 6);
    forEachPixel(pixels, [&](size_t i) {
        constexpr float n = kGroups;
        for (int c = 0; c < 3; ++c) {
            float mean = 0, variance = 0;
            for (int g = 0; g < kGroups; ++g) mean += groups.plane(3 * g + c)[i] * (1 / n);
            for (int g = 0; g < kGroups; ++g) variance += sqr(groups.plane(3 * g + c)[i] - mean) * (1 / (n * (n - 1)));
            result.plane(c)[i] = mean;
            result.plane(3 + c)[i] = variance;
        }
    });
    return result;
}

// Fine to coarse: the estimates of the difference, averaged wider and wider.
std::vector<Planes> averages(const SurfaceFilter& filter, Planes groups, size_t pixels) {
    std::vector<Planes> levels{estimates(groups, pixels)};
    Planes next(pixels, groups.count());
    while (levels.size() < kLevels) {
        filter.average(1 << (levels.size() - 1), groups, next);
        std::swap(groups, next);
        levels.push_back(estimates(groups, pixels));
    }
    return levels;
}

// What of a level's difference to the coarser ones there is about a pixel: its squares, and their noise.
Planes spreadAbout(const SurfaceFilter& filter, int level, const Planes& estimates, const Planes& coarser,
                   size_t pixels) {
    Planes spread(pixels, 6), wider(pixels, 6);
    forEachPixel(pixels, [&](size_t i) {
        for (int c = 0; c < 3; ++c) {
            spread.plane(c)[i] = sqr(estimates.plane(c)[i] - coarser.plane(c)[i]);
            spread.plane(3 + c)[i] = estimates.plane(3 + c)[i];
        }
    });
    // At steps of the level's own width first, because wider ones alone would fall between what there is and draw
    // their lattice.
    for (const int step : {1 << level, 2 << level}) {
        filter.average(step, spread, wider);
        std::swap(spread, wider);
    }
    return spread;
}

// Coarse to fine: of what a level adds to the coarser ones, the share that is not noise, as its neighbourhood has it
// (the local Wiener filter: Lee, "Digital Image Enhancement and Noise Filtering by Use of Local Statistics", 1980).
Planes withoutNoise(const SurfaceFilter& filter, const std::vector<Planes>& levels, size_t pixels) {
    Planes sum(pixels, 3);
    for (int level = kLevels - 1; level >= 0; --level) {
        const Planes& estimates = levels[size_t(level)];
        const Planes spread = spreadAbout(filter, level, estimates, sum, pixels);
        forEachPixel(pixels, [&](size_t i) {
            for (int c = 0; c < 3; ++c) {
                const float squares = spread.plane(c)[i], noise = kCaution * spread.plane(3 + c)[i];
                float& value = sum.plane(c)[i];
                if (squares > noise) value += (estimates.plane(c)[i] - value) * (1 - noise / squares);
            }
        });
    }
    return sum;
}

}  // namespace

IndirectCorrection::IndirectCorrection(const PixelRegion& region)
    : region_(region),
      traced_(kGroups, FilmLayer(region)),
      albedo_(region),
      normal_(region),
      position_(region),
      size_(region) {}

void IndirectCorrection::add(int x, int y, int group, const IndirectAlong& along, float filterWeight, bool looked) {
    traced_[size_t(group)].add(x, y, along.wide, filterWeight);
    albedo_.add(x, y, along.albedo, filterWeight);
    if (!looked) return;
    normal_.add(x, y, Rgb(along.normal.x, along.normal.y, along.normal.z), filterWeight);
    position_.add(x, y, Rgb(along.position.x, along.position.y, along.position.z), filterWeight);
    size_.add(x, y, Rgb(along.pixelSize), filterWeight);
}

void IndirectCorrection::apply(Image& indirect) const {
    for (const FilmLayer& group : traced_)
        if (group.empty()) return;
    const int width = region_.width();
    const size_t pixels = region_.count();
    SurfaceFilter filter(width, region_.height());
    const auto pixelAt = [&](const FilmLayer& layer, size_t i) {
        return layer.value(region_.x0 + int(i) % width, region_.y0 + int(i) / width);
    };
    const auto albedoAt = [&](size_t i) {
        Rgb albedo = pixelAt(albedo_, i);
        for (int c = 0; c < 3; ++c) albedo[c] = std::max(albedo[c], kSmallestAlbedo);
        return albedo;
    };
    Planes differences(pixels, 3 * kGroups);
    forEachPixel(pixels, [&](size_t i) {
        const Rgb n = pixelAt(normal_, i), p = pixelAt(position_, i), albedo = albedoAt(i);
        filter.show(i, Vec3(p.x, p.y, p.z), normalize(Vec3(n.x, n.y, n.z)), pixelAt(size_, i).x);
        const Rgb maps = indirect.rgb(int(i) % width, int(i) / width);
        for (int g = 0; g < kGroups; ++g) {
            const Rgb difference = (pixelAt(traced_[size_t(g)], i) - maps) / albedo;
            for (int c = 0; c < 3; ++c)
                differences.plane(3 * g + c)[i] = std::clamp(difference[c], -kLargest, kLargest);
        }
    });
    const Planes correction = withoutNoise(filter, averages(filter, std::move(differences), pixels), pixels);
    const std::vector<float> near = filter.weights(1);
    forEachPixel(pixels, [&](size_t i) {
        if (!filter.covers(i)) return;
        const int x = int(i) % width, y = int(i) / width;
        Rgb value = indirect.rgb(x, y);
        const Rgb scale = albedoAt(i) * std::clamp((near[i] - kAlone) / (kAmongEnough - kAlone), 0.f, 1.f);
        for (int c = 0; c < 3; ++c) value[c] = std::max(0.f, value[c] + correction.plane(c)[i] * scale[c]);
        indirect.setRgb(x, y, value);
    });
}

}  // namespace drc
