// Writes Radiance's picture format (radiance_hdr.h has its source).
#pragma once
#include <string>

#include "image/image.h"

namespace drc {

// Encodes linear RGB (the first three channels, or grey): 8 bits of each channel and a common exponent, so that the
// error of each channel is at most 1/256 of the largest channel. Negative values and NaN become 0; values beyond 2^127
// become the largest possible value. Rows of 8 to 32767 pixels are run-length encoded. `path` is for messages. Throws
// Error if the image is empty.
std::string encodeRadianceHdr(const Image& linear, const std::string& path = "a Radiance picture");

}  // namespace drc
