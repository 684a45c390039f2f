// `drc image split`.
#include <fmt/core.h>

#include <memory>

#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "app/option_checks.h"
#include "base/error.h"
#include "image/side_by_side.h"

namespace drc {
namespace {

struct SplitOptions {
    std::vector<std::string> inputs;
    std::vector<int> crops;  // four numbers for each part
    bool rows = false;
    int zoom = 1;
    int line = 2;
    std::string layer;
    ImageOutput output;
};

void split(const SplitOptions& options, const CLI::App& command) {
    checkImageOutput(command, options.output);
    if (options.crops.empty() && command.count("--zoom") > 0)
        throw Error("--zoom: it enlarges what --crop cuts out; give a --crop");
    if (!options.crops.empty() && options.rows)
        throw Error("--rows: it is for strips; with --crop, each part has a row and each picture a column");
    if (options.crops.size() % 4 != 0) throw Error("--crop: each takes four numbers, X0 X1 Y0 Y1");
    const bool isShown = isDisplayed(imageOutputKind(options.output.path));
    std::vector<Image> images;
    float stops = 0;
    for (const std::string& path : options.inputs) {
        Image colours = coloursOf(readPictureFile(path), options.layer);
        if (!images.empty() && (colours.width() != images[0].width() || colours.height() != images[0].height()))
            throw Error(fmt::format("{} is {}, but {} is {}: only pictures of one size can be shown side by side", path,
                                    sizeString(colours), options.inputs[0], sizeString(images[0])));
        // All pictures get the exposure of the first, so that they can be compared.
        if (images.empty()) stops = exposureOf(options.output.display, colours);
        images.push_back(isShown ? viewed(colours, options.output.display.view, stops) : std::move(colours));
    }
    std::vector<PixelRect> parts;
    for (size_t i = 0; i < options.crops.size(); i += 4)
        parts.push_back({options.crops[i], options.crops[i + 2], options.crops[i + 1], options.crops[i + 3]});
    const Image sheet =
        parts.empty() ? strips(images, options.rows, options.line) : cutOuts(images, parts, options.zoom, options.line);
    // The pictures are exposed already, and the lines between them must not be exposed.
    ImageOutput output = options.output;
    output.display = {};
    PictureFile file{output.path, sheet};
    if (isShown) file.metadata = displayMetadata(options.output.display.view, stops);
    writeImageOutput(output, std::move(file));
}

}  // namespace

void addImageSplit(CLI::App& image) {
    const auto options = std::make_shared<SplitOptions>();
    CLI::App* command = image.add_subcommand("split", "Show pictures side by side, in strips or cut-out parts");
    command->add_option("PICTURE", options->inputs, "Pictures of one size, from left to right")->required();
    addImageOutput(*command, options->output);
    command
        ->add_option("--crop", options->crops,
                     "X0 X1 Y0 Y1: cut this part, in pixels from the upper left, out of each picture, and show the "
                     "parts beside each other in place of strips; may be repeated, for parts of one size")
        ->expected(4, 4000)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--zoom", options->zoom, "Pixels along each side for one of a part")
        ->capture_default_str()
        ->check(CLI::Range(1, 64));
    command->add_flag("--rows", options->rows, "Strips from top to bottom");
    command->add_option("--line", options->line, "Width in pixels of the white lines between strips and parts")
        ->capture_default_str()
        ->check(CLI::Range(0, 100));
    command->add_option("--layer", options->layer,
                        "The layer or the channel of EXR files to show in place of the beauty");
    command->footer(
        "Of n pictures, the n-th strip shows what the n-th picture has there. All are shown with the exposure of the\n"
        "first, also with --auto-exposure.\n\n"
        "Examples:\n"
        "  drc image split noisy.exr clean.exr -o strips.png --auto-exposure\n"
        "  drc image split a.exr b.exr reference.exr -o details.png --crop 100 180 60 120 --zoom 4");
    command->callback([options, command] { split(*options, *command); });
}

}  // namespace drc
