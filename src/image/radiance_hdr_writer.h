// Writes Radiance's picture format (radiance_hdr.h has its source).
#pragma once
#include <string>

#include "image/image.h"

namespace drc {

// Encodes linear RGB (the first three channels, or grey): 8 bits of each channel and a common exponent, so that the
// largest channel is within 1/256 and the others within 1/256 of the largest. Negative values and NaN become 0; what is
// beyond 2^127 becomes the largest value there is. Rows of 8 to 32767 pixels are run-length encoded. `path` is for
// messages. Throws Error if the image is empty.
std::string encodeRadianceHdr(const Image& linear, const std::string& path = "a Radiance picture");

}  // namespace drc
