// Reads and writes image files: EXR, PNG, JPEG, TIFF, TGA, Radiance HDR and PFM are read, recognised by their first
// bytes.
#pragma once
#include <string>

#include "image/encoded_image.h"
#include "image/exr_writer.h"
#include "image/image.h"
#include "image/image_file.h"
#include "image/png.h"

namespace drc {

// Throws Error, naming the path, if a file is missing, damaged, or of another format. Reads the first of several mip
// levels, and all parts of an EXR (exr_reader.h). If an EXR's data window differs from its display window, the image
// contains the stored pixels.
ImageFile readImageFile(const std::string& path);
// Like readImageFile(), but for a file in memory.
ImageFile decodeImage(const EncodedImage& encoded);
// The values as stored. `encoding`, if not null, receives their encoding.
Image readImage(const std::string& path, Encoding* encoding = nullptr);
// Three channels, linear: integers are decoded from sRGB, or by the gamma that a PNG gives. For an EXR with layers, the
// beauty.
Image readLinearRgb(const std::string& path);
Image linearRgbOf(const ImageFile& file);
float decodedValue(const ImageFile& file, float value);
// Reads the part of a file that a texture or a light shows: the beauty, and its alpha if it has one, cropped to the
// display window and padded there with black of alpha 0. The gamma of a PNG is ignored with a warning, as pbrt does not
// read it.
ImageFile readTextureFile(const std::string& path);
// The string attributes (exr_reader.h). Throws Error if the file is not an EXR.
ExrMetadata readExrMetadata(const std::string& path);

// The string attributes of an EXR, the notes of a PNG, nothing of other formats. Throws Error if the file is damaged.
ExrMetadata readMetadata(const std::string& path);

// Writes linear RGB (the first three channels, or grey) as an 8-bit sRGB PNG, clipped at 1. The file is written
// completely or not at all.
void writePng(const std::string& path, const Image& linear);

}  // namespace drc
