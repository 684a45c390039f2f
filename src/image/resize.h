// Resizes a picture.
#pragma once
#include "image/image.h"

namespace drc {

// Resizes with a tent filter along each axis, two pixels wide in the smaller of the two pictures: enlarging is linear
// interpolation. Filters with negative lobes keep edges sharper, but leave black rims around windows and lamps, whose
// radiance is a hundred times that of their surroundings. Values must be linear and finite. Constant pictures stay
// constant, and a new value stays within the range of the old values around it. Bits do not depend on the number of
// threads. Throws Error if the new size is not positive, is beyond limits::kImageSide or limits::kImagePixels, or needs
// more memory than there is.
Image resized(const Image& image, int width, int height);

}  // namespace drc
