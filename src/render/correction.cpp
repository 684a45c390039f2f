#include "render/correction.h"

#include <array>

#include "base/parallel.h"

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

struct Feature {
    Vec3 p, n;
    Rgb albedo;
    float size = 0;  // 0: nothing is corrected here
};

// What the pixels show, and averages along it.
class SurfaceFilter {
  public:
    SurfaceFilter(int width, int height) : features_(size_t(width) * size_t(height)), width_(width), height_(height) {}

    size_t count() const { return features_.size(); }
    Feature& feature(size_t i) { return features_[i]; }
    bool covers(size_t i) const { return features_[i].size > 0; }

    // f(x, y, index), in parallel.
    template <typename F>
    void forEachPixel(F&& f) const {
        parallelFor(0, height_, 1, [&](int begin, int end) {
            for (int y = begin; y < end; ++y)
                for (int x = 0; x < width_; ++x) f(x, y, index(x, y));
        });
    }

    // The 5x5 neighbours at steps of `dilation` pixels, by the cubic B-spline's weights and by whether they lie on the
    // same surface (the edge-avoiding a-trous filter of Dammertz et al., "Edge-Avoiding A-Trous Wavelet Transform for
    // fast Global Illumination Filtering", 2010): f(neighbour's index, weight). Returns the sum of the weights.
    template <typename F>
    float forEachNear(int x, int y, int dilation, F&& f) const {
        constexpr float kSpline[3] = {0.375f, 0.25f, 0.0625f};
        const Feature& here = features_[index(x, y)];
        float total = 0;
        for (int ky = -2; ky <= 2; ++ky)
            for (int kx = -2; kx <= 2; ++kx) {
                const int nx = x + kx * dilation, ny = y + ky * dilation;
                if (nx < 0 || nx >= width_ || ny < 0 || ny >= height_) continue;
                const Feature& other = features_[index(nx, ny)];
                const float cosine = dot(here.n, other.n);
                if (other.size <= 0 || cosine <= 0) continue;
                // Off the tangent plane, in units of the pixels between.
                const float distance = float(dilation) * std::sqrt(float(kx * kx + ky * ky));
                const float step = absDot(here.n, other.p - here.p) / (here.size * (0.5f * distance + 0.5f));
                const float w =
                    kSpline[std::abs(kx)] * kSpline[std::abs(ky)] * std::exp(-sqr(step)) * sqr(sqr(sqr(sqr(cosine))));
                f(index(nx, ny), w);
                total += w;
            }
        return total;
    }

  private:
    size_t index(int x, int y) const { return size_t(y) * size_t(width_) + size_t(x); }

    std::vector<Feature> features_;
    int width_, height_;
};

// The mean of independent groups, and its variance.
struct Estimate {
    Rgb value{0.f}, variance{0.f};
};
constexpr size_t kGroups = IndirectCorrection::kGroups;
using Groups = std::array<Rgb, kGroups>;

Estimate estimate(const Groups& groups) {
    constexpr float n = kGroups;
    Estimate e;
    for (const Rgb& g : groups) e.value += g * (1.f / n);
    for (const Rgb& g : groups) e.variance += (g - e.value) * (g - e.value) * (1.f / (n * (n - 1)));
    return e;
}

// Fine to coarse: the difference of each group, averaged wider and wider.
std::vector<std::vector<Estimate>> averages(const SurfaceFilter& filter, std::vector<Groups> groups) {
    std::vector<Groups> next(filter.count());
    std::vector<std::vector<Estimate>> levels(kLevels, std::vector<Estimate>(filter.count()));
    for (int level = 0; level < kLevels; ++level) {
        if (level > 0) {
            filter.forEachPixel([&](int x, int y, size_t i) {
                if (!filter.covers(i)) return;
                next[i].fill(Rgb(0.f));
                const float total = filter.forEachNear(x, y, 1 << (level - 1), [&](size_t j, float w) {
                    for (size_t g = 0; g < kGroups; ++g) next[i][g] += groups[j][g] * w;
                });
                for (Rgb& sum : next[i]) sum *= 1 / total;
            });
            groups.swap(next);
        }
        filter.forEachPixel([&](int, int, size_t i) { levels[size_t(level)][i] = estimate(groups[i]); });
    }
    return levels;
}

// What of a level's difference to the coarser ones there is about a pixel, and its noise.
struct Spread {
    Rgb squares{0.f}, noise{0.f};
};
std::vector<Spread> spreadAbout(const SurfaceFilter& filter, int level, const std::vector<Estimate>& estimates,
                                const std::vector<Rgb>& coarser) {
    std::vector<Spread> spread(filter.count()), wider(filter.count());
    filter.forEachPixel([&](int, int, size_t i) {
        const Rgb d = estimates[i].value - coarser[i];
        spread[i] = {d * d, estimates[i].variance};
    });
    // At steps of the level's own width first, because wider ones alone would fall between what there is and draw
    // their lattice.
    for (const int step : {1 << level, 2 << level}) {
        filter.forEachPixel([&](int x, int y, size_t i) {
            if (!filter.covers(i)) return;
            Spread sum;
            const float total = filter.forEachNear(x, y, step, [&](size_t j, float w) {
                sum.squares += spread[j].squares * w;
                sum.noise += spread[j].noise * w;
            });
            wider[i] = {sum.squares * (1 / total), sum.noise * (1 / total)};
        });
        spread.swap(wider);
    }
    return spread;
}

// Coarse to fine: of what a level adds to the coarser ones, the share that is not noise, as its neighbourhood has it
// (the local Wiener filter: Lee, "Digital Image Enhancement and Noise Filtering by Use of Local Statistics", 1980).
std::vector<Rgb> withoutNoise(const SurfaceFilter& filter, const std::vector<std::vector<Estimate>>& levels) {
    std::vector<Rgb> sum(filter.count(), Rgb(0.f));
    for (int level = kLevels - 1; level >= 0; --level) {
        const std::vector<Estimate>& estimates = levels[size_t(level)];
        const std::vector<Spread> spread = spreadAbout(filter, level, estimates, sum);
        filter.forEachPixel([&](int, int, size_t i) {
            if (!filter.covers(i)) return;
            const Rgb d = estimates[i].value - sum[i];
            const auto& [squares, noise] = spread[i];
            for (int c = 0; c < 3; ++c)
                if (squares[c] > kCaution * noise[c]) sum[i][c] += d[c] * (1 - kCaution * noise[c] / squares[c]);
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
    SurfaceFilter filter(region_.width(), region_.height());
    std::vector<Groups> differences(region_.count());
    filter.forEachPixel([&](int x, int y, size_t i) {
        const int fx = region_.x0 + x, fy = region_.y0 + y;
        Feature& f = filter.feature(i);
        const Rgb n = normal_.value(fx, fy), p = position_.value(fx, fy), a = albedo_.value(fx, fy);
        f.n = normalize(Vec3(n.x, n.y, n.z));
        f.p = Vec3(p.x, p.y, p.z);
        f.size = size_.value(fx, fy).x;
        for (int c = 0; c < 3; ++c) f.albedo[c] = std::max(a[c], kSmallestAlbedo);
        for (size_t g = 0; g < kGroups; ++g)
            differences[i][g] = (traced_[g].value(fx, fy) - indirect.rgb(x, y)) / f.albedo;
    });
    const std::vector<Rgb> correction = withoutNoise(filter, averages(filter, std::move(differences)));
    filter.forEachPixel([&](int x, int y, size_t i) {
        if (!filter.covers(i)) return;
        Rgb value = indirect.rgb(x, y);
        const float near = filter.forEachNear(x, y, 1, [](size_t, float) {});
        const Rgb scale = filter.feature(i).albedo * std::clamp((near - kAlone) / (kAmongEnough - kAlone), 0.f, 1.f);
        for (int c = 0; c < 3; ++c) value[c] = std::max(0.f, value[c] + correction[i][c] * scale[c]);
        indirect.setRgb(x, y, value);
    });
}

}  // namespace drc
