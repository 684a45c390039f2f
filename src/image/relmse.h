// Errors in linear radiance, pixel by pixel: mean squared, relative mean squared and mean absolute error.
#pragma once
#include <array>
#include <cstdint>

#include "image/image.h"

namespace drc {

// relMSE leaves out this share of the pixels, those with the largest errors, because a few fireflies would dominate it.
inline constexpr double kRelMseDropped = 0.001;

struct RadianceErrors {
    double relmse = 0;  // mean of (t - r)^2 / (r^2 + 0.01) over channels and all but the worst floor(0.1 %) pixels
    double mse = 0;     // mean of (t - r)^2
    double l1 = 0;      // mean of |t - r|
    // mean(t) / mean(r) of each channel; 1 if both are 0.
    std::array<double, 3> meanRatio{1, 1, 1};
    // The number of pixels with NaN or infinity. All values above leave them out, and are NaN if no pixel is left.
    int64_t nonFiniteReference = 0, nonFiniteTest = 0;
};

// Throws Error if the sizes differ.
RadianceErrors radianceErrors(const Image& reference, const Image& test);

}  // namespace drc
