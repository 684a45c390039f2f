// Image files: EXR, PNG, JPEG, TGA, Radiance HDR and PFM are read, told apart by their first bytes; EXR and PNG are
// written.
#pragma once
#include <string>

#include "image/encoded_image.h"
#include "image/exr_writer.h"
#include "image/image.h"
#include "image/image_file.h"
#include "image/png.h"

namespace drc {

// Throws Error, naming the path, on a file that is missing, of another format or damaged. Of several parts or mip
// levels, the first is read; of a picture larger or smaller than its display window, what is stored.
ImageFile readImageFile(const std::string& path);
// The same of a file in memory.
ImageFile decodeImage(const EncodedImage& encoded);
// The values as stored. `encoding`, if not null, says how.
Image readImage(const std::string& path, Encoding* encoding = nullptr);
// Three channels, linear: what is integer is decoded from sRGB. Of an EXR with layers it is the beauty.
Image readLinearRgb(const std::string& path);
// The string attributes of the first part. Throws Error if it is no EXR.
ExrMetadata readExrMetadata(const std::string& path);

// Linear RGB (the first three channels, or grey) to an 8-bit sRGB PNG; what is above 1 is clipped. All or nothing.
void writePng(const std::string& path, const Image& linear);

}  // namespace drc
