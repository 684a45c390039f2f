// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#pragma once
#include "image/image.h"

namespace drc {

// The size of the window, and so of the smallest image that has an SSIM.
inline constexpr int kSsimWindow = 11;

// Mean SSIM of two linear RGB images of one size, each clamped to [0, 1], sRGB-encoded and reduced to luminance (Rec.
// 709 weights). Gaussian window of 11 x 11 pixels with sigma 1.5, K1 = 0.01, K2 = 0.03, L = 1, weighted (not sample)
// variance; the mean runs over the pixels whose window lies inside the image. The range is [-1, 1], with 1 for equal
// images. NaN if a side is below 11 pixels. Throws Error if the sizes differ.
double ssim(const Image& reference, const Image& test);

}  // namespace drc
