// A picture that shows where a test image differs from its reference.
#pragma once
#include "image/image.h"

namespace drc {

// Four pictures side by side, as linear values in [0, 1] to be encoded as sRGB: reference | test | |difference| | sign.
// The two differences are taken between displayed (exposed, clamped, sRGB-encoded) colours and shown four times as
// large. The third keeps the hue, which shows tints; the fourth is red where the test is brighter and blue where it is
// darker, which shows light leaks and lost light. exposure in stops. Throws Error if the sizes differ.
Image differenceImage(const Image& reference, const Image& test, float exposure = 0);

}  // namespace drc
