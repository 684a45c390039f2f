// TIFF, by libtiff.
#pragma once
#include <string_view>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

bool isTiff(std::string_view bytes);

// The first picture of the file, the largest of a mip-mapped one, turned as its orientation says. Channels "Y" or "R",
// "G", "B", and "A" where it has one; further channels are dropped. 8 and 16 bits are integers, sRGB-encoded, with
// colours that are not multiplied by alpha; 16-, 32- and 64-bit floats are linear, with colours that are. Strips or
// tiles, planes together or apart, any compression that the library has. What has other bits or colours (palettes, 1
// and 4 bits, CMYK, YCbCr, Lab) is read as libtiff shows it, with 8 bits. Throws Error.
ImageFile decodeTiff(const EncodedImage& encoded);

}  // namespace drc
