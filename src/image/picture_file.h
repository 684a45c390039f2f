// A picture's file with all that is in it, as the subcommands of `drc image` read it.
#pragma once
#include <string>

#include "image/exr_storage.h"
#include "image/image_file.h"

namespace drc {

struct PictureFile {
    std::string path;
    // All channels, linear: integers are decoded from sRGB, and their alpha is multiplied in, as EXR files have it.
    Image image;
    Encoding encoding = Encoding::Float;  // of the file
    ExrMetadata metadata{};               // the string attributes of an EXR, the notes of a PNG
    // Set for EXR files only, as in ImageFile.
    ExrWindow window{};
    ExrStorage storage{};
    std::string beautyPart{};
};

// Throws Error as readImageFile does.
PictureFile readPictureFile(const std::string& path);

// The layer that a name stands for: of several parts, the name of the one that is the beauty is "" as well, and the
// names of its channels may have it before theirs.
std::string layerNamed(const PictureFile& picture, const std::string& name);

// The number of pixels of which a channel is NaN or infinite; these channels are set to zero.
int64_t clearNonFinite(Image& image);

}  // namespace drc
