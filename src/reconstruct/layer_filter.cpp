#include "reconstruct/layer_filter.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "base/parallel.h"
#include "film/sample_pass.h"

namespace drc {
namespace {

// The scales of a layer are its pixels and four averages with standard deviations of 1, 2.2, 4.6 and 9.2 pixels.
constexpr int kLevels = 5;
constexpr LayerFilter::Scales kAlongSurfaces{0, kLevels - 1};
// Scales of the filters among edge pixels: farther away, edge pixels mostly belong to another edge. Corrections
// (kAlongEdges) omit the scale of single pixels, whose difference from the base is nearly all noise.
constexpr LayerFilter::Scales kAmongEdgePixels{0, 1}, kAlongEdges{1, 2};
// Layers are divided by albedos of at least kSmallestAlbedo, which bounds the noise. A surface whose albedo is below
// kBlack scatters nothing with these lobes, and gets no light from its neighbours.
constexpr float kSmallestAlbedo = 0.02f, kBlack = 1e-4f;
// The multiple of the estimated variance that counts as noise. One minimises the mean squared error if the noise is
// Gaussian and its variance is known; in corrections, a larger multiple suppresses blotches.
constexpr float kCaution = 1, kCautionOfCorrection = 1.5f;
// A further factor at the scale of single pixels. Most of the apparent detail there comes from two of a pixel's four
// groups that found a bright path by chance, and would show as a dot.
constexpr float kCautionOfDots = 2;
// If only one group finds a bright path, the square of the mean equals its variance, however bright the path is. With a
// factor below one, some of its light would be kept, and would become a blotch of the correction.
constexpr float kLeastCautionOfCorrection = 1.1f;

// For white noise on a plane: the variance of the difference between a pixel and the average of the finest scale around
// it, relative to the pixel's variance. With the spline's weights w it is 1 - 2 w0^2 + (sum of w^2)^2.
constexpr float kNoiseAboveAverage = 0.794f;

// The variance of the average of the finest scale itself, relative to the pixel's variance: (sum of w^2)^2.
constexpr float kNoiseOfAverage = 0.0748f;

// Pixels whose light differs by much more than the noise, as on both sides of a shadow's edge, are not averaged with
// each other. The factor turns a pixel's noise variance into the variance by which filtered pixels may still differ.
constexpr float kNoiseBetween = 0.25f;

// Bounds on the sum of the weights of a pixel's neighbours on its surface, in which its own weight is 0.14. Below
// kAlone it is an edge pixel, a mixture of two surfaces. Its few paths cannot estimate the noise, because paths that
// miss a bright spot agree with each other. Above kAmongEnough there are enough neighbours.
constexpr float kAlone = 0.15f, kAmongEnough = 0.4f;
// Upper bound on a pixel's value: its square, and sums of many squares, are still finite.
constexpr float kLargest = 1e15f;

// The number of groups in the layers to be filtered.
constexpr int kGroups = LayerFilter::kGroups;
// If some pixels have no sample in some group, the groups' means are known only from the first average on. A fourth
// plane of each group then contains the averaged share of pixels that have a sample. If it is below kLeastShare, the
// group counts as unknown.
constexpr float kLeastShare = 1e-3f;

// Calls f(pixel) for all pixels, in parallel.
template <typename F>
void forEachPixel(size_t count, const F& f) {
    constexpr int kGrain = 1 << 14;
    parallelFor(0, int(count), kGrain, [&](int begin, int end) {
        for (auto i = size_t(begin); i < size_t(end); ++i) f(i);
    });
}

// Calls f(pixel) for the pixels that the filter covers: a filter of edge pixels covers few.
template <typename F>
void forEachCovered(const SurfaceFilter& filter, size_t count, const F& f) {
    forEachPixel(count, [&](size_t i) {
        if (filter.covers(i)) f(i);
    });
}

Rgb notBlack(Rgb albedo) {
    for (int c = 0; c < 3; ++c) albedo[c] = std::max(albedo[c], kSmallestAlbedo);
    return albedo;
}

// Mark in the first plane of variances: at this scale, no sample is near enough to estimate the pixel.
constexpr float kUnknown = -1;

// The mean of the independent groups in the first three planes, and the variance of this mean in the other three.
// groups: three planes (RGB) for each group, one group after the other; then one plane for each group with its share,
// unless all groups are known everywhere.
Planes estimates(const SurfaceFilter& filter, const Planes& groups, size_t pixels) {
    Planes result(pixels, 6);
    const bool whole = groups.count() == 3 * kGroups;
    forEachCovered(filter, pixels, [&](size_t i) {
        float perShare[kGroups], n = 0;  // 1 / share; 0: unknown
        for (int g = 0; g < kGroups; ++g) {
            const float share = whole ? 1 : groups.plane(3 * kGroups + g)[i];
            perShare[g] = share > kLeastShare ? 1 / share : 0;
            n += perShare[g] > 0 ? 1 : 0;
        }
        if (n == 0) {
            result.plane(3)[i] = kUnknown;
            return;
        }
        for (int c = 0; c < 3; ++c) {
            const auto value = [&](int g) { return groups.plane(3 * g + c)[i] * perShare[g]; };
            float mean = 0, variance = 0;
            for (int g = 0; g < kGroups; ++g) mean += value(g) * (1 / n);
            for (int g = 0; g < kGroups; ++g)
                if (perShare[g] > 0) variance += sqr(value(g) - mean);
            result.plane(c)[i] = mean;
            // A single group has no variance; all of its value is taken for noise.
            result.plane(3 + c)[i] = n > 1 ? variance * (1 / (n * (n - 1))) : sqr(mean);
        }
    });
    return result;
}

// The estimates from wider and wider averages, from fine to coarse.
std::vector<Planes> averages(const SurfaceFilter& filter, Planes groups, size_t pixels, int coarsest) {
    std::vector<Planes> levels;
    levels.push_back(estimates(filter, groups, pixels));
    Planes next(pixels, groups.count());
    while (int(levels.size()) <= coarsest) {
        filter.average(1 << (levels.size() - 1), groups, next);
        std::swap(groups, next);
        levels.push_back(estimates(filter, groups, pixels));
    }
    return levels;
}

// Buffers that are reused, because allocating so much memory takes time.
struct Spread {
    explicit Spread(size_t pixels) : planes(pixels, 6), wider(pixels, 6) {}
    Planes planes;  // RGB of the squared detail, then RGB of the noise in it
    Planes wider;   // for the next average
};

// The local mean of a level's squared detail, which is its difference from the coarser levels, and of the noise in it.
void spreadAbout(const SurfaceFilter& filter, int level, const Planes& estimates, const Planes& coarser, size_t pixels,
                 Spread& result) {
    auto& [spread, wider] = result;
    forEachCovered(filter, pixels, [&](size_t i) {
        const bool known = estimates.plane(3)[i] != kUnknown;
        for (int c = 0; c < 3; ++c) {
            spread.plane(c)[i] = known ? sqr(estimates.plane(c)[i] - coarser.plane(c)[i]) : 0;
            spread.plane(3 + c)[i] = known ? estimates.plane(3 + c)[i] : 0;
        }
    });
    // The first average is at steps of the level's own width: wider steps alone would skip pixels, and their lattice
    // would show.
    for (const int step : {1 << level, 2 << level}) {
        filter.average(step, spread, wider);
        std::swap(spread, wider);
    }
}

// The actual noise as a share of the estimate from the groups: at most one, and less where all samples of a pixel
// together are better stratified than those of one group. It is the median over the pixels, because most pixels differ
// from their neighbours on the same surface by noise alone. spread: of the scale of single pixels.
float shareOfNoise(const Planes& spread, size_t pixels) {
    std::vector<float> shares;
    for (int c = 0; c < 3; ++c)
        for (size_t i = 0; i < pixels; ++i) {
            const float noise = kNoiseAboveAverage * spread.plane(3 + c)[i];
            if (noise > 0) shares.push_back(spread.plane(c)[i] / noise);
        }
    if (shares.empty()) return 1;
    const auto median = shares.begin() + std::ptrdiff_t(shares.size() / 2);
    std::nth_element(shares.begin(), median, shares.end());
    return std::min(1.f, *median);
}

// From the level `coarsest` down to `finest`: adds to `sum` (the result of the coarser levels, changed in place) the
// detail of each level, reduced to the share of its local variance that is not noise. noisy: for each level, the
// multiple of the variance that counts as noise.
void addWithoutNoise(const SurfaceFilter& filter, const std::vector<Planes>& levels, size_t pixels, int coarsest,
                     int finest, const std::array<float, kLevels>& noisy, Spread& spread, Planes& sum) {
    for (int level = coarsest; level >= finest; --level) {
        const Planes& estimates = levels[size_t(level)];
        spreadAbout(filter, level, estimates, sum, pixels, spread);
        forEachCovered(filter, pixels, [&](size_t i) {
            if (estimates.plane(3)[i] == kUnknown) return;
            for (int c = 0; c < 3; ++c) {
                const float squares = spread.planes.plane(c)[i];
                const float noise = noisy[size_t(level)] * spread.planes.plane(3 + c)[i];
                float& value = sum.plane(c)[i];
                if (squares > noise) value += (estimates.plane(c)[i] - value) * (1 - noise / squares);
            }
        });
    }
}

// How far the filter can be trusted at each pixel, from 0 (an edge pixel) to 1.
std::vector<float> trustIn(const SurfaceFilter& filter) {
    std::vector<float> trust = filter.weights(1);
    for (float& t : trust) t = std::clamp((t - kAlone) / (kAmongEnough - kAlone), 0.f, 1.f);
    return trust;
}

}  // namespace

LayerFilter::LayerFilter(const LobeGBuffer& surfaces, LobeKind lobes)
    : surfaces_(surfaces),
      lobes_(lobes),
      filter_(surfaces.filter(lobes)),
      trust_(trustIn(filter_)),
      amongEdgePixels_(amongEdgePixels()),
      trustAmongEdgePixels_(trustIn(amongEdgePixels_)) {}

bool LayerFilter::isWhole(const FilmLayer& samples) const {
    const PixelRegion& region = surfaces_.region();
    std::atomic<bool> whole{true};
    forEachPixel(region.count(), [&](size_t i) {
        const int column = int(i) % region.width(), row = int(i) / region.width();
        if (filter_.covers(i) && !samples.complete(region.x0 + column, region.y0 + row)) whole = false;
    });
    return whole;
}

LayerFilter::Filtered LayerFilter::withoutNoise(const SurfaceFilter& filter, Scales scales, const FilmLayer& samples,
                                                bool whole, const Image* base) const {
    const PixelRegion& region = surfaces_.region();
    const size_t pixels = region.count();
    Planes groups(pixels, (whole ? 3 : 4) * kGroups);
    forEachPixel(pixels, [&](size_t i) {
        const int column = int(i) % region.width(), row = int(i) / region.width();
        const int x = region.x0 + column, y = region.y0 + row;
        const Rgb known = base ? base->rgb(column, row) : Rgb(0.f);
        const Rgb scale = notBlack(albedo(column, row));
        for (int g = 0; g < kGroups; ++g) {
            if (!whole && !samples.has(x, y, g)) continue;
            if (!whole) groups.plane(3 * kGroups + g)[i] = 1;
            const Rgb value = (samples.group(x, y, g) - known) / scale;
            for (int c = 0; c < 3; ++c) groups.plane(3 * g + c)[i] = std::clamp(value[c], -kLargest, kLargest);
        }
    });
    const std::vector<Planes> levels = averages(filter, std::move(groups), pixels, scales.coarsest);
    const int known = whole ? 0 : 1, finest = std::max(known, scales.finest);
    Spread spread(pixels);
    spreadAbout(filter, 0, levels[size_t(known)], levels[1], pixels, spread);
    const float share = whole ? shareOfNoise(spread.planes, pixels) : 1;
    Filtered result{Planes(pixels, 3), Planes(pixels, 1)};
    // The variance of a pixel's mean is estimated around the pixel, because its own samples are too few.
    const float ofPixel = whole ? share : 1 / kNoiseOfAverage;
    forEachPixel(pixels, [&](size_t i) {
        for (int c = 0; c < 3; ++c) result.noise.plane(0)[i] += ofPixel * spread.planes.plane(3 + c)[i];
    });
    Planes& sum = result.values;
    std::array<float, kLevels> noisy;
    noisy.fill(base ? std::max(kCautionOfCorrection * share, kLeastCautionOfCorrection) : kCaution * share);
    noisy[0] *= kCautionOfDots;
    if (base) {
        addWithoutNoise(filter, levels, pixels, scales.coarsest, finest, noisy, spread, sum);
        return result;
    }
    // A difference from the base may be nothing but noise, and is shrunk at all scales. Light is never zero, so its
    // coarsest average is kept whole, or the picture would darken.
    for (int c = 0; c < 3; ++c) std::copy_n(levels.back().plane(c), pixels, sum.plane(c));
    addWithoutNoise(filter, levels, pixels, scales.coarsest - 1, finest, noisy, spread, sum);
    return result;
}

Planes LayerFilter::withoutNoiseBetweenEdges(SurfaceFilter filter, Scales scales, const FilmLayer& samples,
                                             bool whole) const {
    Filtered first = withoutNoise(filter, scales, samples, whole, nullptr);
    forEachPixel(surfaces_.region().count(), [&](size_t i) { first.noise.plane(0)[i] *= kNoiseBetween; });
    filter.guideBy(std::move(first.values), std::move(first.noise));
    return withoutNoise(filter, scales, samples, whole, nullptr).values;
}

Image LayerFilter::smooth(const FilmLayer& samples) const {
    const PixelRegion& region = surfaces_.region();
    Image result = samples.image();
    fillUnsampled({&result}, samples);
    // Many scenes have no glossy lobes.
    if (std::all_of(result.data().begin(), result.data().end(), [](float v) { return v == 0; })) return result;
    const bool whole = isWhole(samples);
    // Light from maps varies slowly along a surface, and pixels that share maps share their noise, so that a guide
    // would mistake this noise for detail. The other layers have edges, such as shadows, and need a guide.
    const Planes ofSurfaces = lobes_ == LobeKind::Broad
                                  ? withoutNoise(filter_, kAlongSurfaces, samples, whole, nullptr).values
                                  : withoutNoiseBetweenEdges(filter_, kAlongSurfaces, samples, whole);
    // The first few samples cannot estimate the variance between edge pixels.
    const Planes ofEdgePixels = whole ? withoutNoiseBetweenEdges(amongEdgePixels_, kAmongEdgePixels, samples, whole)
                                      : Planes(region.count(), 3);
    forEachPixel(region.count(), [&](size_t i) {
        const int column = int(i) % region.width(), row = int(i) / region.width();
        const int x = region.x0 + column, y = region.y0 + row;
        const Rgb scatters = albedo(column, row);
        if (!filter_.covers(i) || maxComponent(scatters) <= kBlack) return;
        Rgb value = result.rgb(column, row);
        const Rgb scale = notBlack(scatters);
        // A pixel without samples gets the average along its surface, if the pixels around it have samples.
        const bool sampled = samples.groupsWithSamples(x, y) > 0;
        const bool known = ofSurfaces.plane(0)[i] > 0 || ofSurfaces.plane(1)[i] > 0 || ofSurfaces.plane(2)[i] > 0;
        const float surface = sampled ? trust_[i] : known ? 1.f : 0.f;
        const float edge = whole ? (1 - surface) * trustAmongEdgePixels_[i] : 0;
        for (int c = 0; c < 3; ++c)
            value[c] += surface * (ofSurfaces.plane(c)[i] * scale[c] - value[c]) +
                        edge * (ofEdgePixels.plane(c)[i] * scale[c] - value[c]);
        result.setRgb(column, row, value);
    });
    return result;
}

SurfaceFilter LayerFilter::amongEdgePixels() const {
    SurfaceFilter filter(surfaces_.region().width(), surfaces_.region().height());
    const Vec3 anyPoint(0.f), anyNormal(0, 0, 1);
    for (size_t i = 0; i < trust_.size(); ++i)
        if (trust_[i] < 1 && filter_.covers(i)) filter.show(i, anyPoint, anyNormal, 1);
    return filter;
}

void LayerFilter::correct(Image& layer, const FilmLayer& samples) const {
    const PixelRegion& region = surfaces_.region();
    const bool whole = isWhole(samples);
    const Planes ofSurfaces = withoutNoise(filter_, kAlongSurfaces, samples, whole, &layer).values;
    // Maps err at edges, mostly in the same way all along one edge. The first few samples cannot estimate this error.
    const Planes ofEdges =
        whole ? withoutNoise(amongEdgePixels_, kAlongEdges, samples, whole, &layer).values : Planes(region.count(), 3);
    forEachPixel(region.count(), [&](size_t i) {
        const int column = int(i) % region.width(), row = int(i) / region.width();
        if (!filter_.covers(i)) return;
        Rgb value = layer.rgb(column, row);
        const Rgb scale = notBlack(albedo(column, row));
        const float surface = trust_[i], edge = (1 - surface) * trustAmongEdgePixels_[i];
        for (int c = 0; c < 3; ++c) {
            const float correction = surface * ofSurfaces.plane(c)[i] + edge * ofEdges.plane(c)[i];
            value[c] = std::max(0.f, value[c] + correction * scale[c]);
        }
        layer.setRgb(column, row, value);
    });
}

}  // namespace drc
