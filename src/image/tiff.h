// TIFF, by libtiff.
#pragma once
#include <string_view>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

bool isTiff(std::string_view bytes);

// Reads the first picture of the file, the largest of a mip-mapped one, rotated and mirrored as its orientation says.
// Channels "Y" or "R", "G", "B", and "A" if it has alpha; further channels are dropped. The result has sRGB-encoded
// values that are not premultiplied by alpha for 8- and 16-bit integers, and linear values that are premultiplied for
// 16-, 32- and 64-bit floats. Strips or tiles, interleaved or separate planes, any compression that libtiff supports.
// Files with other bits or colours (palettes, 1 and 4 bits, CMYK, YCbCr, Lab) are converted to 8-bit RGBA by libtiff.
// Throws Error.
ImageFile decodeTiff(const EncodedImage& encoded);

}  // namespace drc
