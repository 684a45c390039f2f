#include "reconstruct/temporal_filter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "image/surface_match.h"

namespace drc {
namespace {

// Half the widths of the windows over which differences are averaged, in pixels.
constexpr int kDirectRadius = 2, kIndirectRadius = 4;
// A neighbour counts in full if the squared difference is at most kSurely times its variance, and not at all from
// kNever times on. It always counts where the difference is below this share of the light: too little to be seen.
constexpr double kSurely = 2, kNever = 5, kUnseen = 0.01;

// A neighbour's light where the frame shows the same points; zero where `seen` is.
struct WarpedLight {
    LightHalves direct, indirect;
    Image seen;  // X: MatchedPixels::seen
};

WarpedLight warped(const TemporalFrame& neighbour, const TemporalFrame& frame) {
    if (neighbour.hasParts() != frame.hasParts())
        throw Error(
            fmt::format("{}: it has {} halves of direct light, and {} has {}; all frames must have the same layers",
                        frame.surfaces.name, frame.hasParts() ? "the" : "no", neighbour.surfaces.name,
                        neighbour.hasParts() ? "them" : "none"));
    const SurfaceMatch matches(frame.surfaces, neighbour.surfaces);
    const int width = frame.direct[0].width(), height = frame.direct[0].height();
    WarpedLight light;
    light.seen = Image(width, height, {"X"});
    for (size_t half = 0; half < 2; ++half) {
        light.direct[half] = Image(width, height);
        if (frame.hasParts()) light.indirect[half] = Image(width, height);
    }
    parallelFor(0, height, 4, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                const MatchedPixels match = matches.at(x, y);
                // One pixel, not an interpolation: that would spread a pixel's noise over its neighbours, and denoisers
                // take noise that neighbours share for detail.
                const MatchedPixels::Pixel* pixel = matches.nearest(x, y, match);
                if (pixel == nullptr) continue;
                light.seen.at(x, y, 0) = match.seen;
                for (int c = 0; c < 3; ++c) {
                    const float times = matches.albedoRatio(x, y, *pixel, c);
                    for (size_t half = 0; half < 2; ++half) {
                        light.direct[half].at(x, y, c) = times * neighbour.direct[half].at(pixel->x, pixel->y, c);
                        if (frame.hasParts())
                            light.indirect[half].at(x, y, c) =
                                times * neighbour.indirect[half].at(pixel->x, pixel->y, c);
                    }
                }
            }
    });
    return light;
}

// Sums over square windows of a plane, by running sums.
class WindowSums {
  public:
    WindowSums(int width, int height) : width_(width), height_(height), values_(size_t(width) * size_t(height)) {}
    float& at(int x, int y) { return values_[size_t(y) * size_t(width_) + size_t(x)]; }
    float at(int x, int y) const { return values_[size_t(y) * size_t(width_) + size_t(x)]; }

    void sum(int radius) {
        parallelFor(0, height_, 8, [&](int begin, int end) {
            std::vector<float> line(static_cast<size_t>(width_));
            for (int y = begin; y < end; ++y) {
                for (int x = 0; x < width_; ++x) line[size_t(x)] = at(x, y);
                slide(line, radius, [&](int x, double s) { at(x, y) = float(s); });
            }
        });
        parallelFor(0, width_, 32, [&](int begin, int end) {
            std::vector<float> line(static_cast<size_t>(height_));
            for (int x = begin; x < end; ++x) {
                for (int y = 0; y < height_; ++y) line[size_t(y)] = at(x, y);
                slide(line, radius, [&](int y, double s) { at(x, y) = float(s); });
            }
        });
    }

  private:
    template <class F>
    static void slide(const std::vector<float>& line, int radius, const F& set) {
        const int n = int(line.size());
        for (int i = 0; i < n; ++i) {
            double s = 0;
            for (int k = std::max(0, i - radius); k <= std::min(n - 1, i + radius); ++k) s += double(line[size_t(k)]);
            set(i, s);
        }
    }
    int width_, height_;
    std::vector<float> values_;
};

// The weight of a neighbour's light at each pixel, in [0, 1].
std::vector<float> weightsOf(const LightHalves& own, const LightHalves& other, const Image& seen, int radius) {
    const int width = seen.width(), height = seen.height();
    WindowSums count(width, height);
    std::vector<WindowSums> difference(3, {width, height}), noise(3, {width, height}), light(3, {width, height});
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                if (seen.at(x, y, 0) == 0) continue;
                count.at(x, y) = 1;
                for (int c = 0; c < 3; ++c) {
                    const float a = own[0].at(x, y, c), b = own[1].at(x, y, c);
                    const float p = other[0].at(x, y, c), q = other[1].at(x, y, c);
                    const float d = (a + b - p - q) / 2, e = (a - b - p + q) / 2;
                    difference[size_t(c)].at(x, y) = d;
                    noise[size_t(c)].at(x, y) = e * e;
                    light[size_t(c)].at(x, y) = (a + b + p + q) / 4;
                }
            }
    });
    count.sum(radius);
    for (size_t c = 0; c < 3; ++c) difference[c].sum(radius), noise[c].sum(radius), light[c].sum(radius);
    std::vector<float> weights(seen.pixelCount());
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                if (seen.at(x, y, 0) == 0) continue;
                double squared = 0, variance = 0, unseen = 0;
                for (size_t c = 0; c < 3; ++c) {
                    squared += std::pow(double(difference[c].at(x, y)), 2);
                    variance += double(noise[c].at(x, y));
                    unseen += std::pow(kUnseen * double(light[c].at(x, y)), 2);
                }
                const double excess = std::max(0.0, squared - unseen);
                const double share = excess > kSurely * variance
                                         ? (kNever * variance - excess) / ((kNever - kSurely) * variance + 1e-30)
                                         : 1;
                weights[size_t(y) * size_t(width) + size_t(x)] = seen.at(x, y, 0) * float(std::clamp(share, 0.0, 1.0));
            }
    });
    return weights;
}

// The weighted mean of a frame's light, with weight 1, and its neighbours'.
class Average {
  public:
    explicit Average(const LightHalves& own) : halves_(own), total_(own[0].pixelCount(), 1.f) {}
    void add(const LightHalves& other, const std::vector<float>& weights) {
        for (size_t half = 0; half < 2; ++half)
            forEachPixel([&](size_t i) {
                for (size_t c = 3 * i; c < 3 * i + 3; ++c)
                    halves_[half].data()[c] += weights[i] * other[half].data()[c];
            });
        forEachPixel([&](size_t i) { total_[i] += weights[i]; });
    }
    LightHalves halves() {
        for (Image& half : halves_)
            forEachPixel([&](size_t i) {
                for (size_t c = 3 * i; c < 3 * i + 3; ++c) half.data()[c] /= total_[i];
            });
        return std::move(halves_);
    }
    const std::vector<float>& total() const { return total_; }

  private:
    template <class F>
    void forEachPixel(const F& f) const {
        parallelFor(0, int(total_.size()), 1 << 14, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) f(size_t(i));
        });
    }
    LightHalves halves_;
    std::vector<float> total_;
};

Image sumOf(const Image& a, const Image& b, float times) {
    Image sum = a;
    for (size_t i = 0; i < sum.data().size(); ++i) sum.data()[i] = (sum.data()[i] + b.data()[i]) * times;
    return sum;
}

}  // namespace

Image FilteredFrame::half(size_t i) const { return indirect[i].empty() ? direct[i] : sumOf(direct[i], indirect[i], 1); }
Image FilteredFrame::beauty() const { return sumOf(half(0), half(1), 0.5f); }
Image FilteredFrame::directLight() const { return sumOf(direct[0], direct[1], 0.5f); }

Image FilteredFrame::variance() const {
    const Image a = half(0), b = half(1);
    Image result = a;
    for (size_t i = 0; i < result.data().size(); ++i) {
        const float d = (a.data()[i] - b.data()[i]) / 2;
        result.data()[i] = d * d;
    }
    return result;
}

FilteredFrame filteredOverTime(const TemporalFrame& frame, std::span<const TemporalFrame* const> neighbours) {
    const bool hasParts = frame.hasParts();
    Average direct(frame.direct);
    std::optional<Average> indirect;
    if (hasParts) indirect.emplace(frame.indirect);
    for (const TemporalFrame* neighbour : neighbours) {
        const WarpedLight light = warped(*neighbour, frame);
        const int radius = hasParts ? kDirectRadius : kIndirectRadius;
        direct.add(light.direct, weightsOf(frame.direct, light.direct, light.seen, radius));
        if (hasParts)
            indirect->add(light.indirect, weightsOf(frame.indirect, light.indirect, light.seen, kIndirectRadius));
    }
    FilteredFrame result;
    result.frames = Image(frame.direct[0].width(), frame.direct[0].height(), {"X"});
    result.frames.data() = hasParts ? indirect->total() : direct.total();
    result.direct = direct.halves();
    if (hasParts) result.indirect = indirect->halves();
    return result;
}

}  // namespace drc
