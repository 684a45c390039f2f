// For tests of how errors are measured: pictures with known errors and known noise.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "image/image.h"

namespace drc::noise_testing {

using Rng = std::mt19937;

// The contrast of a room: a gradient, dark squares, a lamp, and highlights of single pixels.
inline Image scene(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Rgb c(0.2f + 0.6f * float(x) / float(width), 0.4f, 0.7f - 0.5f * float(y) / float(height));
            if (x / 12 % 3 == 1 && y / 10 % 3 == 1) c *= 0.1f;
            if (x > width / 2 && x < width / 2 + 9 && y < 9) c = Rgb(20, 18, 15);
            if (x % 37 == 5 && y % 29 == 7) c = Rgb(12);
            image.setRgb(x, y, c);
        }
    return image;
}

// Noise of mean zero, in units of the pixel's radiance or of 1, whichever is smaller: emitters that the camera sees
// have little noise.
using Noise = std::function<float(Rng&)>;

inline Noise gaussian(float deviation) {
    return [=](Rng& rng) { return std::normal_distribution<float>(0, deviation)(rng); };
}

// One pixel in `every` is `size` times too bright; the others are darker by the mean of that excess.
inline Noise fireflies(float every, float size, float deviation) {
    return [=](Rng& rng) {
        const bool bright = std::uniform_real_distribution<float>(0, 1)(rng) < 1 / every;
        return (bright ? size : 0) - size / every + std::normal_distribution<float>(0, deviation)(rng);
    };
}

// Grey noise, like most noise of a path tracer.
inline Image noisy(const Image& image, const Noise& noise, Rng& rng) {
    Image result = image;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const float n = noise(rng);
            for (int c = 0; c < 3; ++c) result.at(x, y, c) += n * std::min(1.f, image.at(x, y, c));
        }
    return result;
}

// The mean of (2 radius + 1)^2 pixels, without those beyond the edge: noise that neighbours share.
inline Image blurred(const Image& image, int radius) {
    Image result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            Rgb sum(0);
            int count = 0;
            for (int v = std::max(0, y - radius); v <= std::min(image.height() - 1, y + radius); ++v)
                for (int u = std::max(0, x - radius); u <= std::min(image.width() - 1, x + radius); ++u)
                    sum += image.rgb(u, v), ++count;
            result.setRgb(x, y, sum / float(count));
        }
    return result;
}

}  // namespace drc::noise_testing
