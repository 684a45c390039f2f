// A picture's file with all that is in it, as the subcommands of `drc image` read it.
#pragma once
#include <string>

#include "image/exr_writer.h"
#include "image/image_file.h"

namespace drc {

struct PictureFile {
    std::string path;
    // All channels, linear: integers are decoded from sRGB, and their alpha is multiplied in, as EXR files have it.
    Image image;
    Encoding encoding = Encoding::Float;  // of the file
    ExrMetadata metadata;                 // the string attributes of an EXR, the notes of a PNG
    ExrWindow window;                     // of an EXR
};

// Throws Error as readImageFile does.
PictureFile readPictureFile(const std::string& path);

// The number of pixels of which a channel is NaN or infinite; these channels are set to zero.
int64_t clearNonFinite(Image& image);

}  // namespace drc
