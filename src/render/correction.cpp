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

struct Feature {
    Vec3 p, n;
    Rgb albedo;
    float size = 0;  // 0: nothing is corrected here
};

// Sums over the 5x5 neighbours at steps of `dilation` pixels, by the cubic B-spline's weights and by whether they lie
// on the same surface (the edge-avoiding a-trous filter of Dammertz et al., "Edge-Avoiding A-Trous Wavelet Transform
// for fast Global Illumination Filtering", 2010): f(neighbour's index, weight). Returns the sum of the weights.
class SurfaceFilter {
  public:
    SurfaceFilter(const std::vector<Feature>& features, int width, int height)
        : features_(features), width_(width), height_(height) {}

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
    const std::vector<Feature>& features_;
    int width_, height_;
};

// The mean of independent groups, and its variance.
struct Estimate {
    Rgb value{0.f}, variance{0.f};
};
template <size_t N>
Estimate estimate(const std::array<Rgb, N>& groups) {
    Estimate e;
    for (const Rgb& g : groups) e.value += g * (1.f / N);
    for (const Rgb& g : groups) e.variance += (g - e.value) * (g - e.value) * (1.f / (N * (N - 1)));
    return e;
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
    const int width = region_.width(), height = region_.height();
    std::vector<Feature> features(region_.count());
    std::vector<std::array<Rgb, kGroups>> groups(region_.count()), next(region_.count());
    const auto forEachPixel = [&](auto&& f) {
        parallelFor(0, height, 1, [&](int begin, int end) {
            for (int y = begin; y < end; ++y)
                for (int x = 0; x < width; ++x) f(x, y, size_t(y) * size_t(width) + size_t(x));
        });
    };
    forEachPixel([&](int x, int y, size_t i) {
        const int fx = region_.x0 + x, fy = region_.y0 + y;
        Feature& f = features[i];
        const Rgb n = normal_.value(fx, fy), p = position_.value(fx, fy), a = albedo_.value(fx, fy);
        f.n = normalize(Vec3(n.x, n.y, n.z));
        f.p = Vec3(p.x, p.y, p.z);
        f.size = size_.value(fx, fy).x;
        for (int c = 0; c < 3; ++c) f.albedo[c] = std::max(a[c], kSmallestAlbedo);
        for (size_t g = 0; g < kGroups; ++g) groups[i][g] = (traced_[g].value(fx, fy) - indirect.rgb(x, y)) / f.albedo;
    });
    const SurfaceFilter filter(features, width, height);

    // Fine to coarse: the difference of each group, averaged wider and wider.
    std::vector<std::vector<Estimate>> levels(kLevels, std::vector<Estimate>(region_.count()));
    for (int level = 0; level < kLevels; ++level) {
        if (level > 0) {
            forEachPixel([&](int x, int y, size_t i) {
                if (features[i].size <= 0) return;
                next[i].fill(Rgb(0.f));
                const float total = filter.forEachNear(x, y, 1 << (level - 1), [&](size_t j, float w) {
                    for (size_t g = 0; g < kGroups; ++g) next[i][g] += groups[j][g] * w;
                });
                for (Rgb& sum : next[i]) sum *= 1 / total;
            });
            groups.swap(next);
        }
        forEachPixel([&](int, int, size_t i) { levels[size_t(level)][i] = estimate(groups[i]); });
    }

    // Coarse to fine: of what a level adds to the coarser ones, the share that is not noise, as its neighbourhood has
    // it (the local Wiener filter: Lee, "Digital Image Enhancement and Noise Filtering by Use of Local Statistics",
    // 1980).
    struct Spread {
        Rgb squares{0.f}, noise{0.f};
    };
    std::vector<Rgb> correction(region_.count(), Rgb(0.f));
    std::vector<Spread> spread(region_.count()), wider(region_.count());
    for (int level = kLevels - 1; level >= 0; --level) {
        const std::vector<Estimate>& estimates = levels[size_t(level)];
        // What the difference and its noise are about a pixel: at steps of the level's own width first, because wider
        // ones alone would fall between what there is and draw their lattice.
        forEachPixel([&](int, int, size_t i) {
            const Rgb d = estimates[i].value - correction[i];
            spread[i] = {d * d, estimates[i].variance};
        });
        for (const int step : {1 << level, 2 << level}) {
            forEachPixel([&](int x, int y, size_t i) {
                if (features[i].size <= 0) return;
                Spread sum;
                const float total = filter.forEachNear(x, y, step, [&](size_t j, float w) {
                    sum.squares += spread[j].squares * w;
                    sum.noise += spread[j].noise * w;
                });
                wider[i] = {sum.squares * (1 / total), sum.noise * (1 / total)};
            });
            spread.swap(wider);
        }
        forEachPixel([&](int, int, size_t i) {
            if (features[i].size <= 0) return;
            const Rgb d = estimates[i].value - correction[i];
            const auto& [squares, noise] = spread[i];
            for (int c = 0; c < 3; ++c)
                if (squares[c] > kCaution * noise[c]) correction[i][c] += d[c] * (1 - kCaution * noise[c] / squares[c]);
        });
    }
    forEachPixel([&](int x, int y, size_t i) {
        if (features[i].size <= 0) return;
        Rgb value = indirect.rgb(x, y);
        for (int c = 0; c < 3; ++c) value[c] = std::max(0.f, value[c] + correction[i][c] * features[i].albedo[c]);
        indirect.setRgb(x, y, value);
    });
}

}  // namespace drc
