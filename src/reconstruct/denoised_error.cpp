#include "reconstruct/denoised_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/convolution.h"
#include "image/cross_error.h"
#include "image/relative_norm.h"

namespace drc {
namespace {

// Standard deviation, in pixels, of the Gaussian that averages the local error: the estimate at a single pixel is as
// noisy as the samples.
constexpr float kAround = 8;

// The picture of one half of the samples. A pixel without samples in that half gets the mean of all its samples.
LayeredPicture halfOf(const LayeredPicture& picture, int group) {
    LayeredPicture half;
    half.film = picture.film;
    half.takenAsComplete = picture.takenAsComplete;
    half.scale = picture.scale;
    // The half has its own G-buffer: that of all samples would give a denoiser information of the other half, such as
    // how much of an edge a pixel shows.
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

// For each pixel, whether it has samples in both halves.
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
    // The norm is made of the denoised halves: the products of the noisy ones are largest where both are bright by
    // chance, which would make the norm large there.
    const Image norm = relativeNorm(a, b);
    const Plane left = relativeProducts(a, noisySecond, a, noisySecond, norm);
    const Plane right = relativeProducts(b, noisyFirst, b, noisyFirst, norm);
    const Plane noise = relativeProducts(noisyFirst, noisySecond, noisyFirst, noisySecond, norm);
    const Plane apart = relativeProducts(a, b, a, b, norm);
    const std::vector<bool> both = pixelsWithHalves(unfiltered);

    // Sums over the pixels that count, for weighted means.
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
    // The squared error of a picture of all samples, given that of the halves: the half of the error that a and b do
    // not share averages out, which is (a - b)^2 / 4, and as much remains at least.
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
