// Separable filters over single-channel images, for the metrics.
#pragma once
#include <cstddef>
#include <vector>

namespace drc {

struct Plane {
    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    float& at(int x, int y) { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    float at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }

    int width = 0, height = 0;
    std::vector<float> values;  // row by row
};

// 2 r + 1 weights, for the offsets -r to r.
using Kernel = std::vector<float>;

// exp(-x^2 / (2 sigma^2)) at -radius..radius, normalised to the sum 1. sigma in pixels.
Kernel gaussianKernel(float sigma, int radius);

// result(x, y) = sum_ij alongX[i] alongY[j] plane(x + i, y + j). Outside the plane, the nearest edge value is used.
// Results do not depend on the number of threads.
Plane convolve(const Plane& plane, const Kernel& alongX, const Kernel& alongY);

}  // namespace drc
