// How much there is to see in a picture, noise included: Shannon's entropy of its histogram of brightness.
#pragma once
#include "image/image.h"

namespace drc {

// Bits a pixel, 0 to 8: of the 256 levels of luminance (Rec. 709) as shown, that is encoded as sRGB and clipped. Takes
// the first three channels, or the first as grey. Throws Error on a picture without pixels.
double luminanceEntropy(const Image& linear);

}  // namespace drc
