// Radiance's picture format: red, green, blue and a common exponent, 8 bits each. Source: G. Ward, "Real Pixels",
// Graphics Gems II, and the file format's chapter of the Radiance manual.
#pragma once
#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "R", "G", "B": m 2^(e - 136) for a mantissa m and the exponent e. Rows may be plain, of the old run-length
// encoding (repeated pixels) or of the new one (each channel by itself). The picture is oriented as its resolution line
// says. EXPOSURE and COLORCORR are ignored. XYZ colours are refused. Throws Error.
ImageFile decodeRadianceHdr(const EncodedImage& encoded);

}  // namespace drc
