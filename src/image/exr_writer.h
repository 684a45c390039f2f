// Writes OpenEXR files with layers, a window and metadata.
#pragma once
#include <string>
#include <vector>

#include "image/exr_storage.h"
#include "image/image.h"

namespace drc {

// One layer of an EXR. The layer "" is the beauty, with channels "R", "G", "B"; those of the layer "direct" are
// "direct.R" and so on.
struct ExrLayer {
    std::string name;
    const Image* image = nullptr;
    bool half = false;  // 16 bits: relative error 2^-11; values beyond 65504 are clamped to it
};

// Writes one part with all layers, and the metadata as string attributes. The file is written completely or not at all:
// a full disk gives one Error with the path and the reason, and leaves the old file. All layers must have the same
// size. The channel types in `storage` refer to full names ("direct.R") and apply in addition to ExrLayer::half.
void writeExr(const std::string& path, const std::vector<ExrLayer>& layers, const ExrMetadata& metadata = {},
              const ExrWindow& window = {}, const ExrStorage& storage = {});
// Like writeExr(), but returns the bytes of the file.
std::string encodeExr(const std::vector<ExrLayer>& layers, const ExrMetadata& metadata = {},
                      const ExrWindow& window = {}, const ExrStorage& storage = {});
// Writes a single layer, the beauty.
void writeExr(const std::string& path, const Image& image, const ExrMetadata& metadata = {});

}  // namespace drc
