#include "app/image_output.h"

#include <fmt/core.h>

#include "app/command.h"
#include "app/display_options.h"
#include "app/picture_writer.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "image/image_layers.h"

namespace drc {

void addImageOutput(CLI::App& command, ImageOutput& output) {
    command.add_option("-o,--output,--outfile", output.path, "Picture to write, .exr or .png")->required();
    addDisplayOptions(command, output.display);
}

void checkImageOutput(const CLI::App& command, const ImageOutput& output) {
    outputKind(output.path);
    refuseDisplayOptionsWithoutPng(command, {output.path});
    checkOutput("-o", output.path);
}

Image coloursOf(const PictureFile& picture, const std::string& layer) {
    try {
        return rgbOfLayer(picture.image, layer);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", picture.path, error.what()));
    }
}

void writeImageOutput(const ImageOutput& output, PictureFile picture, const std::string& layer) {
    picture.metadata["drc:image_command"] = processInfo().commandLine;
    if (outputKind(output.path) == OutputKind::Exr) {
        writeExr(output.path, {{"", &picture.image}}, picture.metadata, picture.window);
        return;
    }
    const Image colours = coloursOf(picture, layer);
    const float stops = exposureOf(output.display, colours);
    for (const auto& [key, text] : displayMetadata(output.display.view, stops)) picture.metadata[key] = text;
    writeFileAtomically(
        output.path, encodePng(viewed(colours, output.display.view, stops), output.path, pngTexts(picture.metadata)));
}

}  // namespace drc
