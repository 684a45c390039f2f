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

// The old pixels that contribute to a new pixel along one axis: weights[k] is the weight of pixel first + k. The
// weights sum to 1.
struct Footprint {
    int first = 0;
    std::vector<float> weights;
};

// The footprints of `to` new pixels over `from` old ones. Where the tent reaches beyond an edge, the weights of the
// pixels inside are scaled up.
std::vector<Footprint> footprints(int from, int to) {
    std::vector<Footprint> result;
    result.reserve(size_t(to));
    const double scale = double(from) / to, width = std::max(1.0, scale);
    for (int i = 0; i < to; ++i) {
        const double centre = (i + 0.5) * scale - 0.5;
        Footprint footprint{std::max(0, int(std::ceil(centre - width))), {}};
        const int last = std::min(from - 1, int(std::floor(centre + width)));
        double sum = 0;
        for (int k = footprint.first; k <= last; ++k) {
            footprint.weights.push_back(float(std::max(0.0, 1 - std::abs(k - centre) / width)));
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
    return resizedAlongY(resizedAlongX(image, width), height);
}

}  // namespace drc
