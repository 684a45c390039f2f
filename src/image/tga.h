// Truevision TGA: palettes, colours and grey, 8 to 32 bits, plain or run-length encoded, from any corner. Source: the
// Truevision TGA File Format Specification, version 2.0.
#pragma once
#include <string_view>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// That a file may be a TGA: the kinds and sizes of its header are ones that exist.
bool hasTgaHeader(std::string_view bytes);
// That it is one of version 2.
bool hasTgaFooter(std::string_view bytes);

// Channels "R", "G", "B", of 32 bits "A" too; or "Y", of 16 bits and with bits of alpha "A" too. First row on top. What
// alpha the single bit of 16-bit colours and the palette have is dropped. Throws Error.
ImageFile decodeTga(const EncodedImage& encoded);

}  // namespace drc
