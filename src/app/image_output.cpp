#include "app/image_output.h"

#include <fmt/core.h>

#include <filesystem>

#include "app/command.h"
#include "app/display_options.h"
#include "app/option_checks.h"
#include "app/usage_error.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "image/image_layers.h"
#include "image/jpeg_writer.h"
#include "image/pfm.h"
#include "image/picture_window.h"
#include "image/radiance_hdr_writer.h"
#include "render/picture_writer.h"

namespace drc {
namespace {

struct NamedKind {
    const char* extension;
    ImageOutputKind kind;
};

constexpr NamedKind kKinds[] = {{".exr", ImageOutputKind::Exr},        {".png", ImageOutputKind::Png},
                                {".jpg", ImageOutputKind::Jpeg},       {".jpeg", ImageOutputKind::Jpeg},
                                {".pfm", ImageOutputKind::Pfm},        {".hdr", ImageOutputKind::RadianceHdr},
                                {".pic", ImageOutputKind::RadianceHdr}};

constexpr const char* kQualityOption = "--jpeg-quality";
constexpr const char* kBitsOption = "--png-bits";

std::string encoded(const ImageOutput& output, const Image& shown, const ExrMetadata& metadata) {
    switch (imageOutputKind(output.path)) {
        case ImageOutputKind::Png:
            return encodePng(shown, output.path, pngTexts(metadata), nullptr,
                             output.pngBits == 16 ? PngBits::Sixteen : PngBits::Eight);
        case ImageOutputKind::Jpeg:
            return encodeJpeg(shown, output.jpegQuality, output.path);
        case ImageOutputKind::RadianceHdr:
            return encodeRadianceHdr(shown, output.path);
        default:
            return encodePfm(shown);
    }
}

// Calls f, and puts the name of the picture's file before the message of an Error that it throws.
template <typename F>
auto ofFile(const PictureFile& picture, const F& f) {
    try {
        return f();
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", picture.path, error.what()));
    }
}

}  // namespace

ImageOutputKind imageOutputKind(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    for (const NamedKind& known : kKinds)
        if (extension == known.extension) return known.kind;
    throw UsageError(fmt::format("-o {}: pictures are written as .jpg, .jpeg, .hdr, .pic, .pfm, .exr or .png", path));
}

bool isDisplayed(ImageOutputKind kind) { return kind == ImageOutputKind::Png || kind == ImageOutputKind::Jpeg; }

void addImageOutput(CLI::App& command, ImageOutput& output) {
    command
        .add_option("-o,--output,--outfile", output.path, "Picture to write: .exr, .png, .jpg, .hdr (Radiance) or .pfm")
        ->required();
    addDisplayOptions(command, output.display);
    command.add_option(kQualityOption, output.jpegQuality, "Quality of a JPEG, from 1 to 100")
        ->capture_default_str()
        ->check(wholeNumberIn(1, 100));
    command.add_option(kBitsOption, output.pngBits, "Bits of each channel of a PNG, 8 or 16")
        ->capture_default_str()
        ->check(CLI::IsMember({8, 16}));
}

void checkImageOutput(const CLI::App& command, const ImageOutput& output) {
    const ImageOutputKind kind = imageOutputKind(output.path);
    if (kind == ImageOutputKind::Exr) {
        refuseDisplayOptionsWithoutPng(command, {output.path});
    } else if (const std::string given = givenDisplayOptions(command); !isDisplayed(kind) && !given.empty()) {
        throw UsageError(fmt::format("{}: {} files stay linear and unexposed; give a .png or .jpg as output", given,
                                     kind == ImageOutputKind::Pfm ? "PFM" : "Radiance HDR"));
    }
    const auto requireKind = [&](const char* option, ImageOutputKind of, const char* extension) {
        if (command.count(option) > 0 && kind != of)
            throw UsageError(fmt::format("{}: {} is no {} file", option, output.path, extension));
    };
    requireKind(kQualityOption, ImageOutputKind::Jpeg, ".jpg");
    requireKind(kBitsOption, ImageOutputKind::Png, ".png");
    checkOutput("-o", output.path);
}

Image coloursOf(const PictureFile& picture, const std::string& layer) {
    return ofFile(picture, [&] { return rgbOfLayer(picture.image, layerNamed(picture, layer)); });
}

Image partOf(const PictureFile& picture, const std::string& layer) {
    return ofFile(picture, [&] { return partOfLayer(picture.image, layerNamed(picture, layer)); });
}

void writeImageOutput(const ImageOutput& output, PictureFile picture, const std::string& layer) {
    picture.metadata["drc:image_command"] = processInfo().commandLine;
    const ImageOutputKind kind = imageOutputKind(output.path);
    if (kind == ImageOutputKind::Exr) {
        writeExr(output.path, {{"", &picture.image}}, picture.metadata, picture.window, picture.storage);
        return;
    }
    const Image colours = coloursOf(picture, layer);
    Image shown = placedInWindow(colours, picture.window, picture.path);
    if (isDisplayed(kind)) {
        const float stops = exposureOf(output.display, colours);
        for (const auto& [key, text] : displayMetadata(output.display.view, stops)) picture.metadata[key] = text;
        shown = viewed(shown, output.display.view, stops);
    }
    writeFileAtomically(output.path, encoded(output, shown, picture.metadata));
}

}  // namespace drc
