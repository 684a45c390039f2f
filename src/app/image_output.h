// The picture that a subcommand of `drc image` writes, as an EXR or a PNG.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "image/display.h"
#include "image/picture_file.h"

namespace drc {

struct ImageOutput {
    std::string path;
    DisplaySettings display;
};

// -o, and the options for how PNG files are displayed.
void addImageOutput(CLI::App& command, ImageOutput& output);
// Called before the work, not after it. Throws Error if the output cannot be written, or if display options are given
// for an EXR.
void checkImageOutput(const CLI::App& command, const ImageOutput& output);
// Writes an EXR with all channels and metadata, or a PNG of the colours of a layer, whole or not at all. Throws Error
// that names the picture's file if it has no such layer.
void writeImageOutput(const ImageOutput& output, PictureFile picture, const std::string& layer = "");

// rgbOfLayer() of a file, with its name in the message of the Error.
Image coloursOf(const PictureFile& picture, const std::string& layer = "");

}  // namespace drc
