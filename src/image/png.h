// PNG, by libpng.
#pragma once
#include <string>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "Y" or "R", "G", "B", and "A" where the file has alpha or names a transparent colour. Palettes become
// colours; 1, 2 and 4 bits become 8. Gamma and colour profiles are ignored. Throws Error.
ImageFile decodePng(const EncodedImage& encoded);

// Encodes linear RGB (the first three channels, or grey) as 8-bit sRGB, clipped at 1. `path` is for messages. Throws
// Error if the image is empty.
std::string encodePng(const Image& linear, const std::string& path = "a PNG");

}  // namespace drc
