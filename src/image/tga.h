// Truevision TGA: palettes, colours and grey, 8 to 32 bits, uncompressed or run-length encoded, with any corner first.
// Source: the Truevision TGA File Format Specification, version 2.0.
#pragma once
#include <string_view>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Whether a file may be a TGA: whether types and sizes in its header are valid.
bool hasTgaHeader(std::string_view bytes);
// Whether it is a TGA of version 2.
bool hasTgaFooter(std::string_view bytes);

// Channels "R", "G", "B", and "A" if colours have 32 bits; or "Y", and "A" if grey has 16 bits that include alpha. The
// first row is at the top. The single alpha bit of 16-bit colours and the alpha of palettes are dropped. Throws Error.
ImageFile decodeTga(const EncodedImage& encoded);

}  // namespace drc
