#include "render/correction.h"

#include <array>

#include "base/parallel.h"

namespace drc {
namespace {

constexpr int kRadius = 8;  // pixels
constexpr float kSigma = 3.5f;
// A pixel. With fewer the filtered noise is larger than most errors of the maps.
constexpr int kMinSamples = 16;
constexpr float kSmallestAlbedo = 0.02f;

// What to believe of estimates of one number by independent groups: the mean of the middle two, shrunk by the share of
// its square that is noise (Wiener's filter), so that where the maps are right nothing is added to them.
float believed(std::array<float, 4> d) {
    std::sort(d.begin(), d.end());
    const float middle = 0.5f * (d[1] + d[2]);
    const float mean = 0.25f * (d[0] + d[1] + d[2] + d[3]);
    float variance = 0;  // of the mean
    for (const float v : d) variance += sqr(v - mean) / (3 * 4);
    // Twice its standard error, or it counts as noise: with four groups that is none too sure.
    const float signal = std::max(0.f, sqr(middle) - 4 * variance);
    return signal > 0 ? middle * signal / (signal + variance) : 0;
}

}  // namespace

IndirectCorrection::IndirectCorrection(const PixelRegion& region)
    : region_(region),
      traced_(kGroups, FilmLayer(region)),
      albedo_(region),
      normal_(region),
      position_(region),
      size_(region) {}

void IndirectCorrection::add(int x, int y, int sample, const Sample& s, float filterWeight) {
    traced_[size_t(sample % kGroups)].add(x, y, s.radiance, filterWeight);
    albedo_.add(x, y, s.albedo, filterWeight);
    normal_.add(x, y, Rgb(s.normal.x, s.normal.y, s.normal.z), filterWeight);
    position_.add(x, y, Rgb(s.position.x, s.position.y, s.position.z), filterWeight);
    size_.add(x, y, Rgb(s.pixelSize), filterWeight);
    if (x == region_.x0 && y == region_.y0) samples_ = sample + 1;
}

void IndirectCorrection::apply(Image& indirect) const {
    if (samples_ < kMinSamples) return;
    struct Feature {
        Vec3 p, n;
        Rgb albedo;
        float size;
    };
    const int width = region_.width(), height = region_.height();
    std::vector<Feature> features(region_.count());
    std::vector<std::array<Rgb, kGroups>> differences(region_.count());
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                const int fx = region_.x0 + x, fy = region_.y0 + y;
                const size_t i = size_t(y) * size_t(width) + size_t(x);
                Feature& f = features[i];
                const Rgb n = normal_.value(fx, fy), p = position_.value(fx, fy), a = albedo_.value(fx, fy);
                f.n = normalize(Vec3(n.x, n.y, n.z));
                f.p = Vec3(p.x, p.y, p.z);
                f.size = size_.value(fx, fy).x;
                for (int c = 0; c < 3; ++c) f.albedo[c] = std::max(a[c], kSmallestAlbedo);
                for (size_t g = 0; g < kGroups; ++g)
                    differences[i][g] = (traced_[g].value(fx, fy) - indirect.rgb(x, y)) / f.albedo;
            }
    });
    parallelFor(0, height, 1, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                const size_t i = size_t(y) * size_t(width) + size_t(x);
                const Feature& f = features[i];
                if (f.size <= 0) continue;
                std::array<Rgb, kGroups> sums;
                sums.fill(Rgb(0.f));
                float total = 0;
                for (int dy = -kRadius; dy <= kRadius; ++dy)
                    for (int dx = -kRadius; dx <= kRadius; ++dx) {
                        if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height) continue;
                        const size_t j = i + size_t(dy * width + dx);
                        const Feature& other = features[j];
                        const float cosine = dot(f.n, other.n);
                        if (cosine <= 0) continue;
                        // Off the tangent plane, in units of the pixels between.
                        const float distance = std::sqrt(float(dx * dx + dy * dy));
                        const float step = absDot(f.n, other.p - f.p) / (f.size * (0.5f * distance + 0.5f));
                        const float w =
                            std::exp(-0.5f * sqr(distance / kSigma) - sqr(step)) * sqr(sqr(sqr(sqr(cosine))));
                        for (size_t g = 0; g < kGroups; ++g) sums[g] += differences[j][g] * w;
                        total += w;
                    }
                if (!(total > 0)) continue;
                Rgb value = indirect.rgb(x, y);
                for (int c = 0; c < 3; ++c) {
                    std::array<float, kGroups> d;
                    for (size_t g = 0; g < kGroups; ++g) d[g] = sums[g][c] / total;
                    value[c] = std::max(0.f, value[c] + believed(d) * f.albedo[c]);
                }
                indirect.setRgb(x, y, value);
            }
    });
}

}  // namespace drc
