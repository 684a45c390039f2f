// Resizes a picture.
#pragma once
#include "image/image.h"

namespace drc {

// By the filter of Mitchell and Netravali ("Reconstruction Filters in Computer Graphics", SIGGRAPH 1988, B = C = 1/3),
// as wide as a pixel of the smaller of both pictures, along each axis. Values must be linear and finite. Constant
// pictures stay constant, and channels without negative values get none: the filter's negative lobes would make dark
// rims beside lamps. Bits do not depend on the number of threads. Throws Error if the new size is not positive or is
// beyond limits::kImageSide, or needs more memory than there is.
Image resized(const Image& image, int width, int height);

}  // namespace drc
