#include "render/surface_filter.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace drc {
namespace {

constexpr float kSpline[3] = {0.375f, 0.25f, 0.0625f};
constexpr float kLeastNoise = 1e-20f;

// exp(-x), nearly; it ends at eight.
float falloff(float x) {
    const float e1 = std::max(0.f, 1 - x * 0.125f), e2 = e1 * e1, e4 = e2 * e2;
    return e4 * e4;
}

bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

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

// A row's pixels side by side, without a branch on any: most of the filter's time is spent here.
void SurfaceFilter::weigh(size_t row, size_t neighbours, int x0, int x1, float spline, float perDistance,
                          float* __restrict w) const {
    const float* __restrict nx = normal_.plane(0) + row;
    const float* __restrict ny = normal_.plane(1) + row;
    const float* __restrict nz = normal_.plane(2) + row;
    const float* __restrict px = point_.plane(0) + row;
    const float* __restrict py = point_.plane(1) + row;
    const float* __restrict pz = point_.plane(2) + row;
    const float* __restrict perSize = perSize_.data() + row;
    const size_t away = neighbours - row;
    for (int x = x0; x < x1; ++x) {
        const size_t i = size_t(x), j = i + away;
        const float cosine = std::max(0.f, nx[i] * nx[j] + ny[i] * ny[j] + nz[i] * nz[j]);
        // Off the tangent plane, in units of the pixels between.
        const float off =
            (nx[i] * (px[j] - px[i]) + ny[i] * (py[j] - py[i]) + nz[i] * (pz[j] - pz[i])) * perSize[i] * perDistance;
        const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4;
        w[i] = spline * falloff(off * off) * (c8 * c8);
    }
}

void SurfaceFilter::weighValues(size_t row, size_t neighbours, int x0, int x1, float* __restrict difference,
                                float* __restrict w) const {
    const size_t away = neighbours - row;
    std::fill(difference + x0, difference + x1, 0.f);
    for (int c = 0; c < guide_->count(); ++c) {
        const float* __restrict value = guide_->plane(c) + row;
        for (int x = x0; x < x1; ++x) difference[x] += sqr(value[x] - value[size_t(x) + away]);
    }
    const float* __restrict noise = noise_->plane(0) + row;
    // Where there is no noise, what is equal still counts.
    for (int x = x0; x < x1; ++x) w[x] *= falloff(difference[x] / (noise[x] + noise[size_t(x) + away] + kLeastNoise));
}

template <typename F>
void SurfaceFilter::forEachNeighbour(int y, int dilation, float* w, F&& f) const {
    const size_t row = size_t(y) * size_t(width_);
    std::vector<float> difference(guide_ ? size_t(width_) : 0);
    for (int ky = -2; ky <= 2; ++ky) {
        const int down = ky * dilation;
        if (y + down < 0 || y + down >= height_) continue;
        for (int kx = -2; kx <= 2; ++kx) {
            const int right = kx * dilation, x0 = std::max(0, -right), x1 = std::min(width_, width_ - right);
            if (x0 >= x1) continue;
            const float distance = float(dilation) * std::sqrt(float(kx * kx + ky * ky));
            const ptrdiff_t offset = ptrdiff_t(down) * width_ + right;
            weigh(row, row + size_t(offset), x0, x1, kSpline[std::abs(kx)] * kSpline[std::abs(ky)],
                  1 / (0.5f * distance + 0.5f), w);
            if (guide_) weighValues(row, row + size_t(offset), x0, x1, difference.data(), w);
            f(x0, x1, offset);
        }
    }
}

void SurfaceFilter::average(int dilation, const Planes& in, Planes& out) const {
    parallelFor(0, height_, 4, [&](int begin, int end) {
        const auto width = size_t(width_);
        std::vector<float> w(width), total(width);
        Planes sum(width, in.count());
        for (int y = begin; y < end; ++y) {
            const size_t row = size_t(y) * width;
            std::fill(total.begin(), total.end(), 0.f);
            std::fill_n(sum.plane(0), width * size_t(in.count()), 0.f);
            forEachNeighbour(y, dilation, w.data(), [&](int x0, int x1, ptrdiff_t offset) {
                for (int x = x0; x < x1; ++x) total[size_t(x)] += w[size_t(x)];
                for (int c = 0; c < in.count(); ++c) {
                    const float* __restrict from = in.plane(c) + row + offset;
                    const float* __restrict by = w.data();
                    float* __restrict to = sum.plane(c);
                    for (int x = x0; x < x1; ++x) to[x] += by[x] * from[x];
                }
            });
            for (int c = 0; c < in.count(); ++c)
                for (size_t x = 0; x < width; ++x)
                    out.plane(c)[row + x] = total[x] > 0 ? sum.plane(c)[x] / total[x] : 0.f;
        }
    });
}

std::vector<float> SurfaceFilter::weights(int dilation) const {
    std::vector<float> total(perSize_.size(), 0.f);
    parallelFor(0, height_, 4, [&](int begin, int end) {
        std::vector<float> w(static_cast<size_t>(width_));
        for (int y = begin; y < end; ++y) {
            float* const sum = total.data() + size_t(y) * size_t(width_);
            forEachNeighbour(y, dilation, w.data(), [&](int x0, int x1, ptrdiff_t) {
                for (int x = x0; x < x1; ++x) sum[x] += w[size_t(x)];
            });
        }
    });
    return total;
}

}  // namespace drc
