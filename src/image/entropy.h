// The amount of detail in a picture, noise included: the Shannon entropy of its luminance histogram.
#pragma once
#include "image/image.h"

namespace drc {

// In bits a pixel, 0 to 8, for the 256 levels of luminance (Rec. 709) as displayed, that is encoded as sRGB and
// clipped. Uses the first three channels, or the first as grey. Throws Error if the picture has no pixels.
double luminanceEntropy(const Image& linear);

}  // namespace drc
