// `drc image convert`.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "base/error.h"
#include "base/limits.h"
#include "base/log.h"
#include "image/image_layers.h"
#include "image/picture_window.h"
#include "image/resize.h"

namespace drc {
namespace {

struct ConvertOptions {
    std::string input;
    std::string layer;
    std::vector<int> crop;
    std::string size;
    ImageOutput output;
};

struct Size {
    int width = 0, height = 0;
};

// "640x360", "640x" or "x360"; a missing side follows from the other by the aspect ratio.
Size parseSize(const std::string& text, const Image& image) {
    const auto fail = [&]() -> Size {
        throw Error(
            fmt::format("--resize {}: give a width, a height or both in pixels of at most {}, as 640x360, 640x "
                        "or x360",
                        text, limits::kImageSide));
    };
    const size_t x = text.find('x');
    if (x == std::string::npos || text.size() < 2) return fail();
    const auto side = [&](const std::string& digits) {
        if (digits.empty()) return 0;
        if (digits.size() > 6 || digits.find_first_not_of("0123456789") != std::string::npos) return -1;
        const int value = std::stoi(digits);
        return value >= 1 && value <= limits::kImageSide ? value : -1;
    };
    Size size{side(text.substr(0, x)), side(text.substr(x + 1))};
    if (size.width < 0 || size.height < 0) return fail();
    const auto scaled = [](int other, int own, int of) { return std::max(1L, std::lround(double(other) * own / of)); };
    const long width = size.width ? size.width : scaled(size.height, image.width(), image.height());
    const long height = size.height ? size.height : scaled(size.width, image.height(), image.width());
    if (width > limits::kImageSide || height > limits::kImageSide) return fail();
    return {int(width), int(height)};
}

void crop(PictureFile& picture, const std::vector<int>& c) {
    try {
        picture.image = picture.image.crop(c[0], c[2], c[1], c[3]);
    } catch (const Error& error) {
        throw Error(fmt::format("--crop: {}: {}", picture.path, error.what()));
    }
    // The part keeps its place in the whole picture.
    picture.window.x += c[0], picture.window.y += c[2];
}

void resize(PictureFile& picture, const std::string& text) {
    const Size size = parseSize(text, picture.image);
    if (const int64_t bad = clearNonFinite(picture.image); bad > 0)
        logWarning(fmt::format("{}: {} pixel(s) are NaN or infinite; they are taken as black", picture.path, bad));
    // These layers cannot be resized: counts and variances are no densities, and filtered neighbours share their noise.
    // Nor can points and numbers of surfaces, which are no colours, and motion, which is counted in pixels.
    picture.image =
        withoutLayers(picture.image, {kVarianceLayer, kSampleCountLayer, kErrorLayer, kPositionLayer, kDepthLayer,
                                      kObjectIndexLayer, kMaterialIndexLayer, kVectorLayer, kHalfLayers[0],
                                      kHalfLayers[1], kDirectHalfLayers[0], kDirectHalfLayers[1]});
    picture.image = resized(picture.image, size.width, size.height);
    picture.window = {};
}

// Replaces the picture's channels by the colours of a layer or of a channel, stored in the same type.
void selectLayer(PictureFile& picture, const std::string& layer) {
    const std::vector<std::string> names = partOf(picture, layer).channelNames();
    const auto mapped = [&](const std::set<std::string>& stored) {
        const bool all =
            std::all_of(names.begin(), names.end(), [&](const auto& name) { return stored.contains(name); });
        return all ? std::set<std::string>{"R", "G", "B"} : std::set<std::string>{};
    };
    Image colours = coloursOf(picture, layer);
    picture.storage.halfChannels = mapped(picture.storage.halfChannels);
    picture.storage.integerChannels = mapped(picture.storage.integerChannels);
    picture.image = std::move(colours);
    picture.beautyPart.clear();
}

void convert(const ConvertOptions& options, const CLI::App& command) {
    checkImageOutput(command, options.output);
    PictureFile picture = readPictureFile(options.input);
    if (!options.layer.empty()) selectLayer(picture, options.layer);
    if (!options.crop.empty()) {
        crop(picture, options.crop);
        // Only EXR has a data window; other formats would pad the crop to the full picture.
        if (imageOutputKind(options.output.path) != ImageOutputKind::Exr) picture.window = {};
    }
    if (!options.size.empty()) {
        if (options.crop.empty()) {
            picture.image = placedInWindow(picture.image, picture.window, picture.path);
        } else {
            // These attributes say where the whole picture lies in the world.
            for (const char* name : {"screenWindowCenter", "screenWindowWidth", "worldToNDC", "envmap"})
                picture.storage.attributes.erase(name);
        }
        resize(picture, options.size);
    }
    writeImageOutput(options.output, std::move(picture));
}

}  // namespace

void addImageConvert(CLI::App& image) {
    const auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = image.add_subcommand(
        "convert", "Write a picture as an EXR, PNG, JPEG, Radiance HDR or PFM, exposed, cropped, resized");
    command->add_option("PICTURE", options->input, "Picture to read")->required();
    addImageOutput(*command, options->output);
    command->add_option(
        "--layer", options->layer,
        "The layer or the channel of an EXR to write in place of all: direct, Denoising Normal, Z or depth.Z");
    command
        ->add_option("--crop", options->crop,
                     "X0 X1 Y0 Y1: the part of the picture to keep, in its pixels from the "
                     "upper left; X1 and Y1 are the first beyond it")
        ->type_size(4)
        ->expected(1);
    command->add_option("--resize", options->size,
                        "WIDTHxHEIGHT, WIDTHx or xHEIGHT in pixels, after --crop; by a tent filter, in "
                        "linear light");
    command->footer(
        "An EXR keeps all channels of the picture, halves as halves, its attributes, compression and windows, and "
        "stays\n"
        "linear and unexposed. A resized one has no variance, sample counts, halves, and points\n"
        "and numbers of surfaces. In formats without windows, a part of "
        "a\n"
        "picture is placed where it lies in the whole, unless --crop is given.\n\n"
        "Examples:\n"
        "  drc image convert render.exr -o small.png --resize 640x --exposure -1 --view filmic\n"
        "  drc image convert render.exr -o depth.pfm --layer \"Denoising Depth\"");
    command->callback([options, command] { convert(*options, *command); });
}

}  // namespace drc
