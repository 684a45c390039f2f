// Image files: EXR, PFM, PNG, JPEG, TGA, HDR and whatever else OpenImageIO reads; EXR and PNG are written.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"

namespace drc {

// How a file stores its values. Integers are read as [0, 1]; pictures stored so are sRGB-encoded by custom.
enum class Encoding { UInt8, UInt16, Float };

struct ImageFile {
    Image image;  // values as stored: integers are neither decoded nor multiplied by alpha
    Encoding encoding = Encoding::Float;
    bool isSrgbEncoded() const { return encoding != Encoding::Float; }
};

// Throws Error, naming the path, on a file that is missing, of an unknown format or damaged. Of several parts or
// mip levels, the first is read; of a picture larger or smaller than its display window, what is stored.
ImageFile readImageFile(const std::string& path);
// The values as stored. `encoding`, if not null, says how.
Image readImage(const std::string& path, Encoding* encoding = nullptr);
// Three channels, linear: what is integer is decoded from sRGB. Of an EXR with layers it is the beauty.
Image readLinearRgb(const std::string& path);

// Linear RGB (the first three channels, or grey) to an 8-bit sRGB PNG; what is above 1 is clipped. All or nothing.
void writePng(const std::string& path, const Image& linear);
// The same in memory.
std::string encodePng(const Image& linear);

// One layer of an EXR. The layer "" is the beauty, with channels "R", "G", "B"; those of "direct" are "direct.R" ...
struct ExrLayer {
    std::string name;
    const Image* image = nullptr;
    bool half = false;  // 16 bits: relative error 2^-11; values beyond 65504 are clamped to it
};

// Where the image lies in the whole picture, in pixels, for renders of a part. 0: the image is the whole picture.
struct ExrWindow {
    int x = 0, y = 0;
    int fullWidth = 0, fullHeight = 0;
};

using ExrMetadata = std::map<std::string, std::string>;

// One part, ZIP-compressed, with all layers; metadata as string attributes. All or nothing: a full disk gives one Error
// with the path and the reason, and leaves the old file. All layers must have the same size.
void writeExr(const std::string& path, const std::vector<ExrLayer>& layers, const ExrMetadata& metadata = {},
              const ExrWindow& window = {});
// The same in memory.
std::string encodeExr(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata = {},
                      const ExrWindow& window = {});
// One layer, the beauty.
void writeExr(const std::string& path, const Image& image, const ExrMetadata& metadata = {});
// The string attributes of the first part. Throws Error if it is no EXR.
ExrMetadata readExrMetadata(const std::string& path);

}  // namespace drc
