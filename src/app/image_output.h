// The picture that a subcommand of `drc image` writes.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "image/display.h"
#include "image/picture_file.h"

namespace drc {

enum class ImageOutputKind { Exr, Png, Jpeg, RadianceHdr, Pfm };
// The kind of file by its extension. Throws Error that lists the known ones on any other.
ImageOutputKind imageOutputKind(const std::string& path);
// Whether it holds displayed colours, with an exposure and a view, and not linear radiance.
bool isDisplayed(ImageOutputKind kind);

struct ImageOutput {
    std::string path;
    DisplaySettings display;
    int jpegQuality = 95;
    int pngBits = 8;
};

// -o, the options for how PNG and JPEG files are displayed, and those of single formats.
void addImageOutput(CLI::App& command, ImageOutput& output);
// Called before the work, not after it. Throws Error if the output cannot be written, or if options are given that are
// not for its format.
void checkImageOutput(const CLI::App& command, const ImageOutput& output);
// Writes an EXR with all channels, attributes and windows, or the colours of a layer, whole or not at all. Formats
// without windows get the whole picture: its part is placed in it. Throws Error that names the picture's file if it has
// no such layer.
void writeImageOutput(const ImageOutput& output, PictureFile picture, const std::string& layer = "");

// rgbOfLayer() of a file, with its name in the message of the Error.
Image coloursOf(const PictureFile& picture, const std::string& layer = "");
// partOfLayer() in the same way.
Image partOf(const PictureFile& picture, const std::string& layer);

}  // namespace drc
