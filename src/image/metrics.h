// All image metrics at once: how far a test image is from its reference.
#pragma once
#include <array>
#include <cstdint>

#include "image/image.h"

namespace drc {

struct Metrics {
    double ssim = 0;                           // ssim.h; NaN if a side is below 11 pixels
    double flip = 0;                           // flip.h, mean
    double relmse = 0, mse = 0, l1 = 0;        // relmse.h
    double blockRelmse = 0;                    // relMSE of means of 8x8 pixels: errors correlated between neighbours
    std::array<double, 3> meanRatio{1, 1, 1};  // mean(test) / mean(reference) of R, G and B
    // The size of the 8-bit sRGB PNGs of reference and test, in units of 1000 bytes: a measure of noise, which does not
    // compress.
    std::array<double, 2> pngKb{};
    // The number of pixels with NaN or infinity; see RadianceErrors. SSIM, FLIP and the PNG take NaN as black and
    // +infinity as white.
    int64_t nonFiniteReference = 0, nonFiniteTest = 0;
};

// Compares two linear RGB images. exposure: stops (a factor of 2^exposure) for metrics of displayed colours: SSIM, FLIP
// and the PNGs. Throws Error, naming both sizes, if they differ.
Metrics compare(const Image& reference, const Image& test, float exposure = 0);

// The first three channels, multiplied by 2^stops.
Image exposed(const Image& image, float stops);

}  // namespace drc
