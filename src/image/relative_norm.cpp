#include "image/relative_norm.h"

#include <algorithm>
#include <cmath>

#include "image/convolution.h"

namespace drc {
namespace {

constexpr float kMostOverDarker = 2;

// The Gaussian kernel `all` along one axis, split into the weights beside the hole and those within it.
struct RingKernel {
    Kernel all, beside, within;
    explicit RingKernel(const RingWindow& ring)
        : all(gaussianKernel(ring.sigma, ring.radius)), beside(all), within(all) {
        for (int i = -ring.radius; i <= ring.radius; ++i)
            (std::abs(i) <= ring.hole ? beside : within)[size_t(i + ring.radius)] = 0;
    }
    // Sums of positive terms: nothing cancels, however bright the pixels in the hole are.
    Plane sums(const Plane& plane) const {
        Plane rows = convolve(plane, all, beside);
        const Plane sides = convolve(plane, beside, within);
        for (size_t i = 0; i < rows.values.size(); ++i) rows.values[i] += sides.values[i];
        return rows;
    }
};

float withoutFireflies(float a, float b) {
    a = std::max(a, 0.f), b = std::max(b, 0.f);
    return std::min((a + b) / 2, kMostOverDarker * std::min(a, b));
}

}  // namespace

Image relativeNorm(const Image& first, const Image& second, const RingWindow& ring) {
    requireSameSize(first, second);
    const int margin = ring.radius;
    const int width = first.width(), height = first.height();
    // Padded with zeros, because convolve() repeats the pixels at the edge, which would bring p's own value into S(p).
    const Plane empty(width + 2 * margin, height + 2 * margin);
    Plane known = empty, values[3] = {empty, empty, empty};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb a = first.rgb(x, y), b = second.rgb(x, y);
            if (!isFinite(a) || !isFinite(b)) continue;
            known.at(x + margin, y + margin) = 1;
            for (int c = 0; c < 3; ++c) values[c].at(x + margin, y + margin) = withoutFireflies(a[c], b[c]);
        }
    const RingKernel kernel(ring);
    const Plane weights = kernel.sums(known);
    Image norm(width, height);
    for (int c = 0; c < 3; ++c) {
        const Plane sums = kernel.sums(values[c]);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float weight = weights.at(x + margin, y + margin);
                const float around = weight > 0 ? sums.at(x + margin, y + margin) / weight : 0;
                const float own = std::min(first.rgb(x, y)[c], second.rgb(x, y)[c]) / 2;
                norm.at(x, y, c) = std::isfinite(own) ? std::max(around, own) : around;
            }
    }
    return norm;
}

}  // namespace drc
