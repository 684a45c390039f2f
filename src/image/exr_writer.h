// Writes OpenEXR files with layers, a window and metadata.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "image/image.h"

namespace drc {

// One layer of an EXR. The layer "" is the beauty, with channels "R", "G", "B"; those of the layer "direct" are
// "direct.R" and so on.
struct ExrLayer {
    std::string name;
    const Image* image = nullptr;
    bool half = false;  // 16 bits: relative error 2^-11; values beyond 65504 are clamped to it
};

// The position of the image in the whole picture, in pixels, for renders of a part. A size of 0: the image is the whole
// picture.
struct ExrWindow {
    int x = 0, y = 0;
    int fullWidth = 0, fullHeight = 0;
};

using ExrMetadata = std::map<std::string, std::string>;

// One part, ZIP-compressed, with all layers; metadata as string attributes. The file is written whole or not at all: a
// full disk gives one Error with the path and the reason, and leaves the old file. All layers must have the same size.
void writeExr(const std::string& path, const std::vector<ExrLayer>& layers, const ExrMetadata& metadata = {},
              const ExrWindow& window = {});
// The same in memory.
std::string encodeExr(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata = {},
                      const ExrWindow& window = {});
// One layer, the beauty.
void writeExr(const std::string& path, const Image& image, const ExrMetadata& metadata = {});

}  // namespace drc
