#include "reconstruct/surface_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <experimental/simd>

#include "base/parallel.h"

namespace drc {
namespace {

namespace stdx = std::experimental;
// Adjacent pixels of a row.
using Lanes = stdx::native_simd<float>;
constexpr int kLanes = int(Lanes::size());

constexpr float kSpline[3] = {0.375f, 0.25f, 0.0625f};
constexpr float kLeastNoise = 1e-20f;
constexpr int kReach = 2, kNeighbours = (2 * kReach + 1) * (2 * kReach + 1);

// Approximates exp(-x); zero from x = 8 on.
Lanes falloff(const Lanes& x) {
    const Lanes e1 = stdx::max(Lanes(0.f), 1 - x * 0.125f), e2 = e1 * e1, e4 = e2 * e2;
    return e4 * e4;
}

bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[gnu::noinline]] Lanes loadAtEnd(const float* row, int x, int width) {
    return Lanes([&](int lane) { return x + lane >= 0 && x + lane < width ? row[x + lane] : 0.f; });
}
// The row's values from x on, with zeros beyond its ends.
inline Lanes load(const float* row, int x, int width) {
    if (x >= 0 && x + kLanes <= width) [[likely]]
        return Lanes(row + x, stdx::element_aligned);
    return loadAtEnd(row, x, width);
}

// Stores only the values within the row.
void store(const Lanes& values, float* row, int x, int width) {
    if (x + kLanes <= width)
        values.copy_to(row + x, stdx::element_aligned);
    else
        for (int lane = 0; x + lane < width; ++lane) row[x + lane] = values[size_t(lane)];
}

}  // namespace

// The neighbours of the pixels of a row, at steps of `dilation`, in the rows that exist.
struct SurfaceFilter::Neighbours {
    Neighbours(int y, int dilation, int width, int height) {
        for (int ky = -kReach; ky <= kReach; ++ky) {
            const int64_t other = y + int64_t(ky) * dilation;
            if (other < 0 || other >= height) continue;
            for (int kx = -kReach; kx <= kReach; ++kx) {
                const float distance = float(dilation) * std::sqrt(float(kx * kx + ky * ky));
                all[size_t(count++)] = {size_t(other) * size_t(width), kx * dilation,
                                        kSpline[std::abs(kx)] * kSpline[std::abs(ky)], 1 / (0.5f * distance + 0.5f)};
            }
        }
    }
    struct Neighbour {
        size_t row;  // index of the first pixel of its row
        int right;
        float spline, perDistance;
    };
    std::array<Neighbour, kNeighbours> all;
    int count = 0;
};

// The existing neighbours of a group of adjacent pixels, with their weights.
struct SurfaceFilter::Weights {
    struct From {
        size_t row;
        int x;
    };
    std::array<From, kNeighbours> from;
    std::array<Lanes, kNeighbours> weight;
    int count;
    Lanes total;
};

SurfaceFilter::SurfaceFilter(int width, int height)
    : width_(width),
      height_(height),
      point_(size_t(width) * size_t(height), 3),
      normal_(size_t(width) * size_t(height), 3),
      perSize_(size_t(width) * size_t(height), 0.f) {}

void SurfaceFilter::guideBy(Planes values, Planes noise) {
    guide_ = std::move(values);
    noise_ = std::move(noise);
}

void SurfaceFilter::show(size_t i, const Vec3& p, const Vec3& n, float size) {
    const float perSize = 1 / size;
    const bool shown = size > 0 && std::isfinite(perSize) && isFinite(p) && isFinite(n);
    for (int c = 0; c < 3; ++c) {
        point_.plane(c)[i] = shown ? p[c] : 0;
        normal_.plane(c)[i] = shown ? n[c] : 0;
    }
    perSize_[i] = shown ? perSize : 0;
}

// Most of the filter's time is spent here and in average(), which therefore have no branch on single pixels.
void SurfaceFilter::weigh(size_t row, int x, const Neighbours& neighbours, Weights& result) const {
    const auto here = [&](const Planes& planes, int c) { return load(planes.plane(c) + row, x, width_); };
    const Lanes nx = here(normal_, 0), ny = here(normal_, 1), nz = here(normal_, 2);
    const Lanes px = here(point_, 0), py = here(point_, 1), pz = here(point_, 2);
    const Lanes perSize = load(perSize_.data() + row, x, width_);
    result.count = 0;
    result.total = 0;
    // Filters of edge pixels cover few pixels, so whole groups are often empty.
    if (stdx::all_of(perSize == 0)) return;
    for (int k = 0; k < neighbours.count; ++k) {
        const Neighbours::Neighbour& to = neighbours.all[size_t(k)];
        const int other = x + to.right;
        if (other + kLanes <= 0 || other >= width_) continue;
        const auto there = [&](const Planes& planes, int c) { return load(planes.plane(c) + to.row, other, width_); };
        // Beyond the row's ends the normal is zero, and so is the weight.
        const Lanes cosine =
            stdx::max(Lanes(0.f), nx * there(normal_, 0) + ny * there(normal_, 1) + nz * there(normal_, 2));
        // The distance from the tangent plane, relative to the distance of the pixels on the surface.
        const Lanes off = (nx * (there(point_, 0) - px) + ny * (there(point_, 1) - py) + nz * (there(point_, 2) - pz)) *
                          perSize * to.perDistance;
        const Lanes c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4;
        const auto n = size_t(result.count++);
        result.from[n] = {to.row, other};
        result.weight[n] = to.spline * falloff(off * off) * (c8 * c8);
    }
    if (guide_) weighValues(row, x, result);
    for (int k = 0; k < result.count; ++k) result.total += result.weight[size_t(k)];
}

void SurfaceFilter::weighValues(size_t row, int x, Weights& weights) const {
    // Positive even without noise, so that equal values keep their weight.
    const Lanes noise = load(noise_->plane(0) + row, x, width_) + kLeastNoise;
    for (size_t k = 0; k < size_t(weights.count); ++k) {
        const Weights::From& from = weights.from[k];
        Lanes difference = 0;
        for (int c = 0; c < guide_->count(); ++c) {
            const float* const values = guide_->plane(c);
            const Lanes d = load(values + row, x, width_) - load(values + from.row, from.x, width_);
            difference += d * d;
        }
        weights.weight[k] *= falloff(difference / (noise + load(noise_->plane(0) + from.row, from.x, width_)));
    }
}

// Calls f(row, x, weights) for groups of adjacent pixels, row by row, in parallel; the last groups of a row may
// overlap.
template <typename F>
void SurfaceFilter::forEachWeighed(int dilation, const F& f) const {
    constexpr int kGrain = 4;
    parallelFor(0, height_, kGrain, [&](int begin, int end) {
        Weights weights;
        for (int y = begin; y < end; ++y) {
            const size_t row = size_t(y) * size_t(width_);
            const Neighbours neighbours(y, dilation, width_, height_);
            for (int next = 0; next < width_; next += kLanes) {
                const int x = std::max(0, std::min(next, width_ - kLanes));
                weigh(row, x, neighbours, weights);
                f(row, x, weights);
            }
        }
    });
}

void SurfaceFilter::average(int dilation, const Planes& in, Planes& out) const {
    forEachWeighed(dilation, [&](size_t row, int x, const Weights& weights) {
        const auto setMean = [&](int c, const Lanes& sum) {
            Lanes mean = sum / weights.total;
            stdx::where(!(weights.total > 0), mean) = 0;
            store(mean, out.plane(c) + row, x, width_);
        };
        int c = 0;
        // Three planes at once, so that each weight is read once for all of them. The sums are separate variables,
        // which the compiler keeps in registers.
        for (; c + 3 <= in.count(); c += 3) {
            const float *const plane0 = in.plane(c), *const plane1 = in.plane(c + 1), *const plane2 = in.plane(c + 2);
            Lanes sum0 = 0, sum1 = 0, sum2 = 0;
            for (size_t k = 0; k < size_t(weights.count); ++k) {
                const Weights::From& from = weights.from[k];
                const Lanes w = weights.weight[k];
                sum0 += w * load(plane0 + from.row, from.x, width_);
                sum1 += w * load(plane1 + from.row, from.x, width_);
                sum2 += w * load(plane2 + from.row, from.x, width_);
            }
            setMean(c, sum0);
            setMean(c + 1, sum1);
            setMean(c + 2, sum2);
        }
        for (; c < in.count(); ++c) {
            Lanes sum = 0;
            for (size_t k = 0; k < size_t(weights.count); ++k)
                sum += weights.weight[k] * load(in.plane(c) + weights.from[k].row, weights.from[k].x, width_);
            setMean(c, sum);
        }
    });
}

std::vector<float> SurfaceFilter::weights(int dilation) const {
    std::vector<float> total(perSize_.size());
    forEachWeighed(dilation, [&](size_t row, int x, const Weights& weights) {
        store(weights.total, total.data() + row, x, width_);
    });
    return total;
}

}  // namespace drc
