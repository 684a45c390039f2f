#include "image/convolution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/parallel.h"

namespace drc {
namespace {

constexpr int kRowsPerPiece = 16;

}  // namespace

Kernel gaussianKernel(float sigma, int radius) {
    Kernel kernel;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        kernel.push_back(std::exp(-float(i * i) / (2 * sigma * sigma)));
        sum += kernel.back();
    }
    for (float& w : kernel) w = static_cast<float>(w / sum);
    return kernel;
}

Plane convolve(const Plane& plane, const Kernel& alongX, const Kernel& alongY) {
    const int width = plane.width, height = plane.height;
    const int rx = static_cast<int>(alongX.size() / 2), ry = static_cast<int>(alongY.size() / 2);
    Plane rows(width, height), result(width, height);
    parallelFor(0, height, kRowsPerPiece, [&](int begin, int end) {
        std::vector<float> padded(size_t(width + 2 * rx));
        for (int y = begin; y < end; ++y) {
            for (int x = -rx; x < width + rx; ++x) padded[size_t(x + rx)] = plane.at(std::clamp(x, 0, width - 1), y);
            for (size_t i = 0; i < alongX.size(); ++i)
                for (int x = 0; x < width; ++x) rows.at(x, y) += alongX[i] * padded[size_t(x) + i];
        }
    });
    parallelFor(0, height, kRowsPerPiece, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (size_t j = 0; j < alongY.size(); ++j) {
                const int from = std::clamp(y + static_cast<int>(j) - ry, 0, height - 1);
                for (int x = 0; x < width; ++x) result.at(x, y) += alongY[j] * rows.at(x, from);
            }
        }
    });
    return result;
}

}  // namespace drc
