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
    double blockRelmse = 0;                    // relMSE of the means of 8x8 pixels: errors without their noise
    std::array<double, 3> meanRatio{1, 1, 1};  // mean(test) / mean(reference) of R, G and B
    // Size of the sRGB 8-bit PNG of reference and test, in units of 1000 bytes: noise does not compress.
    std::array<double, 2> pngKb{};
    // Pixels with NaN or an infinity; see RadianceErrors. SSIM, FLIP and the PNG show NaN as black and +infinity as
    // white.
    int64_t nonFiniteReference = 0, nonFiniteTest = 0;
};

// Of two linear RGB images. exposure: stops (factor 2^exposure) for what works on displayed colours: SSIM, FLIP and the
// PNGs. Throws Error, naming both sizes, if they differ.
Metrics compare(const Image& reference, const Image& test, float exposure = 0);

// The first three channels times 2^stops.
Image exposed(const Image& image, float stops);

}  // namespace drc
