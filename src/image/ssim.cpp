#include "image/ssim.h"

#include <limits>

#include "image/color.h"
#include "image/convolution.h"

namespace drc {
namespace {

Plane encodedLuminance(const Image& image) {
    Plane plane(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) plane.at(x, y) = luminance(srgbEncode(clamp01(image.rgb(x, y))));
    return plane;
}

// The windowed mean of a * b.
Plane meanOfProduct(const Plane& a, const Plane& b, const Kernel& window) {
    Plane product(a.width, a.height);
    for (size_t i = 0; i < a.values.size(); ++i) product.values[i] = a.values[i] * b.values[i];
    return convolve(product, window, window);
}

}  // namespace

double ssim(const Image& reference, const Image& test) {
    requireSameSize(reference, test);
    if (reference.width() < kSsimWindow || reference.height() < kSsimWindow)
        return std::numeric_limits<double>::quiet_NaN();
    constexpr int kRadius = kSsimWindow / 2;
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    const Kernel window = gaussianKernel(1.5f, kRadius);
    const Plane r = encodedLuminance(reference), t = encodedLuminance(test);
    const Plane meanR = convolve(r, window, window), meanT = convolve(t, window, window);
    const Plane meanRR = meanOfProduct(r, r, window), meanTT = meanOfProduct(t, t, window);
    const Plane meanRT = meanOfProduct(r, t, window);

    double sum = 0;
    for (int y = kRadius; y < r.height - kRadius; ++y) {
        for (int x = kRadius; x < r.width - kRadius; ++x) {
            const double mr = meanR.at(x, y), mt = meanT.at(x, y);
            const double varR = meanRR.at(x, y) - mr * mr, varT = meanTT.at(x, y) - mt * mt;
            const double covariance = meanRT.at(x, y) - mr * mt;
            sum += (2 * mr * mt + kC1) * (2 * covariance + kC2) / ((mr * mr + mt * mt + kC1) * (varR + varT + kC2));
        }
    }
    return sum / (double(r.width - 2 * kRadius) * double(r.height - 2 * kRadius));
}

}  // namespace drc
