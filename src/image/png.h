// PNG, by libpng.
#pragma once
#include <map>
#include <string>

#include "image/encoded_image.h"
#include "image/image_file.h"

namespace drc {

// Channels "Y" or "R", "G", "B", and "A" where the file has alpha or names a transparent colour. Palettes become
// colours; 1, 2 and 4 bits become 8. Values are as stored: what the file says of its gamma is told beside them. Colour
// profiles are ignored. Throws Error.
ImageFile decodePng(const EncodedImage& encoded);

// Notes in a PNG: keywords of 1 to 79 characters, ASCII, and texts.
using PngTexts = std::map<std::string, std::string>;

// The notes of a file that are not compressed (tEXt and iTXt), in UTF-8; Latin-1 beyond ASCII becomes "?". Damaged ones
// are left out, and so is what comes after the file's end, if it is cut short: notes do not change the pixels.
PngTexts decodePngTexts(const EncodedImage& encoded);

enum class PngBits { Eight, Sixteen };

// Encodes linear RGB (the first three channels, or grey) as sRGB, clipped at 1. alpha: the first channel of an
// image of the same size, by which the colours are not multiplied; null: all is opaque. `path` is for messages. Throws
// Error if the image is empty or a keyword is not one.
std::string encodePng(const Image& linear, const std::string& path = "a PNG", const PngTexts& texts = {},
                      const Image* alpha = nullptr, PngBits bits = PngBits::Eight);

}  // namespace drc
