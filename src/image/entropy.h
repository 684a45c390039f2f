// The amount of detail in a picture, noise included: the Shannon entropy of its luminance histogram.
#pragma once
#include "image/image.h"

namespace drc {

// Bits per pixel, 0 to 8, for 256 levels of displayed luminance: Rec. 709, encoded as sRGB and clipped. Uses the first
// three channels, or the first as grey. Throws Error if the picture has no pixels.
double luminanceEntropy(const Image& linear);

}  // namespace drc
