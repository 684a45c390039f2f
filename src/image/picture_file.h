// The full contents of a picture's file, as the subcommands of `drc image` read it.
#pragma once
#include <string>

#include "image/exr_storage.h"
#include "image/image_file.h"

namespace drc {

struct PictureFile {
    std::string path;
    // All channels, linear: integers are decoded from sRGB and premultiplied by alpha, as EXR files are.
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

// Resolves a name given by the user to a layer or channel of the image. In a file of several parts, the name of the
// beauty part stands for the layer "", and may precede the names of its layers and channels.
std::string layerNamed(const PictureFile& picture, const std::string& name);

// Sets NaN and infinite values to zero. Returns the number of pixels that had any.
int64_t clearNonFinite(Image& image);

}  // namespace drc
