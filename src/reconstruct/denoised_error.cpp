#include "reconstruct/denoised_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/convolution.h"
#include "image/cross_error.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

// The standard deviation of the Gaussian that the local error is averaged by, in pixels: the noise of the estimate at a
// single pixel is as large as that of the samples.
constexpr float kAround = 8;

// The picture of the samples of one half. Where a pixel has none of them, all of its samples take their place.
LayeredPicture halfOf(const LayeredPicture& picture, int group) {
    LayeredPicture half;
    half.film = picture.film;
    half.takenAsComplete = picture.takenAsComplete;
    half.scale = picture.scale;
    // The G-buffer of all samples tells a denoiser what the other half knows, such as how much of an edge a pixel
    // shows.
    if (picture.gBuffer) half.gBuffer = gBufferOf(*picture.film, group);
    half.samples = picture.samples;
    const PixelRegion& region = picture.film->region();
    for (const PictureLayer& whole : picture.layers) {
        const FilmLayer& samples = picture.film->layer(whole.name);
        PictureLayer& layer = half.layers.emplace_back(whole);
        for (float& v : layer.variance->data()) v *= 2;
        for (int row = 0; row < layer.mean.height(); ++row)
            for (int column = 0; column < layer.mean.width(); ++column) {
                const int x = region.x0 + column, y = region.y0 + row;
                if (samples.has(x, y, group)) layer.mean.setRgb(column, row, samples.group(x, y, group) * half.scale);
            }
    }
    half.compose();
    return half;
}

// Where a pixel has samples in both halves.
std::vector<bool> pixelsWithHalves(const LayeredPicture& picture) {
    const PixelRegion& region = picture.film->region();
    std::vector<bool> both(size_t(region.count()), true);
    for (const PictureLayer& layer : picture.layers) {
        const FilmLayer& samples = picture.film->layer(layer.name);
        for (size_t i = 0; i < both.size(); ++i) {
            const int x = region.x0 + int(i) % region.width(), y = region.y0 + int(i) / region.width();
            if (!samples.complete(x, y)) both[i] = false;
        }
    }
    return both;
}

}  // namespace

DenoisedError estimateDenoisedError(const LayeredPicture& unfiltered,
                                    const std::function<void(LayeredPicture&)>& filter) {
    LayeredPicture first = halfOf(unfiltered, 0), second = halfOf(unfiltered, 1);
    const Image noisyFirst = first.part(""), noisySecond = second.part("");
    filter(first);
    filter(second);
    const Image &a = first.beauty, &b = second.beauty;
    // Not of the noisy halves: their products are largest where both are bright by chance, which would make the norm
    // large there.
    const Image norm = relativeNorm(a, b);
    const Plane left = relativeProducts(a, noisySecond, a, noisySecond, norm);
    const Plane right = relativeProducts(b, noisyFirst, b, noisyFirst, norm);
    const Plane noise = relativeProducts(noisyFirst, noisySecond, noisyFirst, noisySecond, norm);
    const Plane apart = relativeProducts(a, b, a, b, norm);
    const std::vector<bool> both = pixelsWithHalves(unfiltered);

    // Weighted means over the pixels that count.
    Plane error(norm.width(), norm.height()), differing = error, weight = error;
    double sum = 0, sumApart = 0, count = 0;
    for (size_t i = 0; i < both.size(); ++i) {
        const float e = (left.values[i] + right.values[i] - noise.values[i]) / 2;
        if (!both[i] || !std::isfinite(e) || !std::isfinite(apart.values[i])) continue;
        error.values[i] = e;
        differing.values[i] = apart.values[i];
        weight.values[i] = 1;
        sum += e;
        sumApart += apart.values[i];
        ++count;
    }
    // Half of what a and b do not share is gone in a picture of all samples, and a quarter of (a - b)^2 is left. This
    // much the error is at least.
    const auto ofAll = [](double halves, double apartSquared) {
        return std::sqrt(std::max(halves - apartSquared / 4, apartSquared / 4));
    };
    DenoisedError result{Image(norm.width(), norm.height(), {"X"}), std::numeric_limits<double>::quiet_NaN()};
    if (count == 0) return result;
    result.whole = ofAll(sum / count, sumApart / count);
    const Kernel around = gaussianKernel(kAround, int(3 * kAround));
    error = convolve(error, around, around);
    differing = convolve(differing, around, around);
    weight = convolve(weight, around, around);
    for (size_t i = 0; i < both.size(); ++i) {
        const float w = weight.values[i];
        result.local.data()[i] = w > 0 ? float(ofAll(error.values[i] / w, differing.values[i] / w)) : 0;
    }
    return result;
}

}  // namespace drc
