// PNG, by libpng.
#pragma once
#include <string>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "Y" or "R", "G", "B", and "A" where the file has alpha or names a transparent colour. Palettes become
// colours; 1, 2 and 4 bits become 8. Gamma and colour profiles change nothing. Throws Error.
ImageFile decodePng(const EncodedImage& encoded);

// Linear RGB (the first three channels, or grey) to 8-bit sRGB; what is above 1 is clipped. `path` is for messages.
// Throws Error if the image is empty.
std::string encodePng(const Image& linear, const std::string& path = "a PNG");

}  // namespace drc
