#include "image/resize.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/limits.h"
#include "base/memory.h"
#include "base/parallel.h"

namespace drc {
namespace {

constexpr float kFilterRadius = 2;

float mitchell(float x) {
    constexpr float kB = 1 / 3.f, kC = 1 / 3.f;
    x = std::abs(x);
    const float square = x * x, cube = square * x;
    if (x < 1) return ((12 - 9 * kB - 6 * kC) * cube + (-18 + 12 * kB + 6 * kC) * square + 6 - 2 * kB) / 6;
    if (x < 2)
        return ((-kB - 6 * kC) * cube + (6 * kB + 30 * kC) * square + (-12 * kB - 48 * kC) * x + 8 * kB + 24 * kC) / 6;
    return 0;
}

// The pixels from `first` on that a new pixel is made of, and their weights, which sum to 1.
struct Footprint {
    int first = 0;
    std::vector<float> weights;
};

// Beyond an edge there is nothing: the weights within are scaled up.
std::vector<Footprint> footprints(int from, int to) {
    std::vector<Footprint> result;
    result.reserve(size_t(to));
    const double scale = double(from) / to, width = std::max(1.0, scale);
    for (int i = 0; i < to; ++i) {
        const double centre = (i + 0.5) * scale - 0.5;
        Footprint footprint{std::max(0, int(std::ceil(centre - kFilterRadius * width))), {}};
        const int last = std::min(from - 1, int(std::floor(centre + kFilterRadius * width)));
        double sum = 0;
        for (int k = footprint.first; k <= last; ++k) {
            footprint.weights.push_back(mitchell(float((k - centre) / width)));
            sum += footprint.weights.back();
        }
        for (float& weight : footprint.weights) weight = float(weight / sum);
        result.push_back(std::move(footprint));
    }
    return result;
}

Image resizedAlongX(const Image& image, int width) {
    Image result(width, image.height(), image.channelNames());
    const std::vector<Footprint> all = footprints(image.width(), width);
    const auto channels = size_t(image.channels());
    parallelFor(0, image.height(), 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x) {
                const Footprint& footprint = all[size_t(x)];
                float* to = result.pixel(x, y);
                const float* from = image.pixel(footprint.first, y);
                for (const float weight : footprint.weights)
                    for (size_t c = 0; c < channels; ++c) to[c] += weight * *from++;
            }
    });
    return result;
}

Image resizedAlongY(const Image& image, int height) {
    Image result(image.width(), height, image.channelNames());
    const std::vector<Footprint> all = footprints(image.height(), height);
    const size_t row = size_t(image.width()) * size_t(image.channels());
    parallelFor(0, height, 8, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const Footprint& footprint = all[size_t(y)];
            float* to = result.pixel(0, y);
            for (size_t k = 0; k < footprint.weights.size(); ++k) {
                const float* from = image.pixel(0, footprint.first + int(k));
                for (size_t i = 0; i < row; ++i) to[i] += footprint.weights[k] * from[i];
            }
        }
    });
    return result;
}

}  // namespace

Image resized(const Image& image, int width, int height) {
    if (width < 1 || height < 1 || width > limits::kImageSide || height > limits::kImageSide ||
        int64_t(width) * height > limits::kImagePixels)
        throw Error(fmt::format("a picture cannot be resized to {}x{}: at most {} a side and {} pixels in all", width,
                                height, limits::kImageSide, limits::kImagePixels));
    const double pixels = double(width) * (double(image.height()) + double(height));
    const MemoryClaim memory(pixels * image.channels() * sizeof(float),
                             fmt::format("a picture of {}x{} pixels", width, height));
    Image result = resizedAlongY(resizedAlongX(image, width), height);
    std::vector<float> lowest(size_t(image.channels()), 0.f);
    const auto forEachValue = [](auto& values, size_t channels, const auto& f) {
        for (size_t i = 0; i < values.size(); ++i) f(values[i], i % channels);
    };
    forEachValue(image.data(), lowest.size(), [&](float v, size_t c) { lowest[c] = std::min(lowest[c], v); });
    forEachValue(result.data(), lowest.size(), [&](float& v, size_t c) { v = std::max(lowest[c], v); });
    return result;
}

}  // namespace drc
