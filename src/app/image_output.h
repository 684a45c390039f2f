// The picture that a subcommand of `drc image` writes.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "image/display.h"
#include "image/picture_file.h"

namespace drc {

enum class ImageOutputKind { Exr, Png, Jpeg, RadianceHdr, Pfm };
// The kind of file by its extension. Throws UsageError, which lists the known extensions, if it is another one.
ImageOutputKind imageOutputKind(const std::string& path);
// Whether files of this kind contain displayed colours, with an exposure and a view, rather than linear radiance.
bool isDisplayed(ImageOutputKind kind);

struct ImageOutput {
    std::string path;
    DisplaySettings display;
    int jpegQuality = 95;
    int pngBits = 8;
};

// Adds -o, the options for how PNG and JPEG files are displayed, and the options of single formats.
void addImageOutput(CLI::App& command, ImageOutput& output);
// Called before the work. Throws Error if the output cannot be written, or if options are given that do not apply to
// its format.
void checkImageOutput(const CLI::App& command, const ImageOutput& output);
// Writes the picture, whole or not at all: an EXR gets all channels, attributes and windows, other formats get the
// colours of `layer`. Formats without windows get the whole picture, with the part in its place. Throws Error, which
// names the picture's file, if it has no such layer.
void writeImageOutput(const ImageOutput& output, PictureFile picture, const std::string& layer = "");

// rgbOfLayer() of a file, whose name comes first in the message of an Error.
Image coloursOf(const PictureFile& picture, const std::string& layer = "");
// partOfLayer() of a file, whose name comes first in the message of an Error.
Image partOf(const PictureFile& picture, const std::string& layer);

}  // namespace drc
