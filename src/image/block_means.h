// Means of square blocks of pixels: averaging removes noise, but not errors that are correlated between neighbours.
#pragma once
#include "image/image.h"

namespace drc {

// The size of the blocks that `drc compare` uses.
inline constexpr int kComparedBlock = 8;

// The mean of each size x size block of pixels, R, G, B; blocks at the right and lower edge may be smaller. Pixels with
// NaN or an infinity are left out; a block without other pixels is NaN. Throws Error if size is not positive.
Image blockMeans(const Image& image, int size);

}  // namespace drc
