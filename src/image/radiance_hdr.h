// Radiance's pictures of red, green, blue and a common exponent, 8 bits each. Source: G. Ward, "Real Pixels", Graphics
// Gems II, and the file format's chapter of the Radiance manual.
#pragma once
#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "R", "G", "B": m 2^(e - 136) of a mantissa m and the exponent e. Rows may be plain, of the old run-length
// encoding (repeated pixels) or of the new one (each channel by itself). The picture is turned upright, as its line of
// the size says. EXPOSURE and COLORCORR are not divided by. XYZ colours are refused. Throws Error.
ImageFile decodeRadianceHdr(const EncodedImage& encoded);

}  // namespace drc
