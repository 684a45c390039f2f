// PNG, by libpng.
#pragma once
#include <map>
#include <string>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "Y" or "R", "G", "B", and "A" if the file has alpha or names a transparent colour. Palettes become colours;
// 1, 2 and 4 bits become 8. Values are as stored; ImageFile::gamma contains the file's gamma. Colour profiles are
// ignored. Throws Error.
ImageFile decodePng(const EncodedImage& encoded);

// Text notes of a PNG by keyword: 1 to 79 ASCII characters.
using PngTexts = std::map<std::string, std::string>;

// The uncompressed notes of a file (tEXt and iTXt), in UTF-8; Latin-1 characters beyond ASCII become "?". Damaged
// notes, and those that are missing from a truncated file, are left out without an error, because notes do not affect
// the pixels.
PngTexts decodePngTexts(const EncodedImage& encoded);

enum class PngBits { Eight, Sixteen };

// Encodes linear RGB (the first three channels, or grey) as sRGB, clipped at 1. alpha: an image of the same size, whose
// first channel is alpha; the colours must not be premultiplied by it. null: all is opaque. `path` is for messages.
// Throws Error if the image is empty or a keyword is not one.
std::string encodePng(const Image& linear, const std::string& path = "a PNG", const PngTexts& texts = {},
                      const Image* alpha = nullptr, PngBits bits = PngBits::Eight);

}  // namespace drc
