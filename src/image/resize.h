// Resizes a picture.
#pragma once
#include "image/image.h"

namespace drc {

// By a tent as wide as two pixels of the smaller of both pictures, along each axis: interpolates linearly where the
// picture becomes larger. Filters with negative lobes, which keep edges sharper, leave black rims around windows and
// lamps, whose radiance is a hundred times that of what stands beside them. Values must be linear and finite. Constant
// pictures stay constant, and values stay within the range of those around. Bits do not depend on the number of
// threads. Throws Error if the new size is not positive or is beyond limits::kImageSide, or needs more memory than
// there is.
Image resized(const Image& image, int width, int height);

}  // namespace drc
