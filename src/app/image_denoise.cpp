// `drc image denoise`.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/image_output.h"
#include "app/image_subcommands.h"
#include "app/option_checks.h"
#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"
#include "image/color.h"
#include "image/image_layers.h"
#include "reconstruct/open_image_denoise.h"

namespace drc {
namespace {

struct DenoiseOptions {
    std::string input;
    std::string layer, albedo, normal;
    std::string quality = "high";
    std::string prefilter = "on";
    std::string library;
    int threads = 0;
    ImageOutput output;
};

// The names of these layers in DRC and in Blender's Cycles, in pbrt-v4's gbuffer film, and in other programs.
const std::vector<std::string> kAlbedoNames{"Denoising Albedo", "albedo", "Albedo"},
    kNormalNames{"Denoising Normal", "normal", "Normal", "Ns", "N"};

// The layer `wanted` or, if that is empty, the first of the known layers, also with another name before it as in
// "ViewLayer.Denoising Albedo"; empty if there is none. Throws Error if there is no layer `wanted`.
Image findLayer(const PictureFile& picture, const std::string& wanted, const std::vector<std::string>& known) {
    if (!wanted.empty()) return coloursOf(picture, wanted);
    for (const std::string& name : known)
        for (const std::string& layer : layerNames(picture.image))
            if (layer == name || layer.ends_with("." + name)) return coloursOf(picture, layer);
    return {};
}

// The names of the guide layers that are missing, for the metadata and a warning; empty if none is.
std::string missingGuides(const Image& albedo, const Image& normal) {
    if (!albedo.empty()) return normal.empty() ? "normal" : "";
    return normal.empty() ? "albedo and normal" : "albedo";
}

void warnOfMissingGuides(const PictureFile& picture, const std::string& missing) {
    if (missing.empty()) return;
    const char* more = missing == "albedo" ? " Without albedo, Open Image Denoise takes no normals either." : "";
    logWarning(
        fmt::format("{}: it has no layer of {}, as drc render --aovs writes them: more detail is lost.{} "
                    "--albedo and --normal name layers of other names, of {}",
                    picture.path, missing, more, layerList(picture.image)));
}

OidnSettings settingsOf(const DenoiseOptions& options) {
    return {options.quality == "high"       ? OidnQuality::High
            : options.quality == "balanced" ? OidnQuality::Balanced
                                            : OidnQuality::Fast,
            options.prefilter == "on"      ? OidnAuxiliaries::Prefiltered
            : options.prefilter == "clean" ? OidnAuxiliaries::Clean
                                           : OidnAuxiliaries::Raw};
}

void denoise(const DenoiseOptions& options, const CLI::App& command) {
    checkImageOutput(command, options.output);
    setThreadCount(options.threads);
    PictureFile picture = readPictureFile(options.input);
    Image albedo = findLayer(picture, options.albedo, kAlbedoNames),
          normal = findLayer(picture, options.normal, kNormalNames);
    const std::string missing = missingGuides(albedo, normal);
    warnOfMissingGuides(picture, missing);
    if (albedo.empty()) normal = {};
    Image colours = coloursOf(picture, options.layer);
    const auto clear = [&](Image& image, const char* name) {
        if (const int64_t bad = clearNonFinite(image); bad > 0)
            logWarning(fmt::format("{}: {} pixel(s) of {} are NaN or infinite; they are taken as black", picture.path,
                                   bad, name));
    };
    clear(colours, "the picture"), clear(albedo, "albedo"), clear(normal, "normal");
    for (float& v : albedo.data()) v = clamp01(v);
    const OpenImageDenoise library(findOidn(OidnSearch::ofProcess(options.library)));
    library.denoise(colours, albedo, normal, settingsOf(options));
    try {
        setRgbOfLayer(picture.image, layerNamed(picture, options.layer), colours);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", picture.path, error.what()));
    }
    // The error was that of the picture before denoising.
    picture.metadata.erase("drc:error");
    picture.image = withoutLayers(picture.image, {kErrorLayer});
    picture.metadata["drc:denoiser"] = "oidn " + options.quality +
                                       (!missing.empty()             ? " without " + missing
                                        : options.prefilter == "off" ? " without prefilter"
                                                                     : "");
    writeImageOutput(options.output, std::move(picture), options.layer);
}

}  // namespace

void addImageDenoise(CLI::App& image) {
    const auto options = std::make_shared<DenoiseOptions>();
    CLI::App* command = image.add_subcommand("denoise", "Remove the noise of a render by Open Image Denoise");
    command->add_option("RENDER", options->input, "An EXR, best with albedo and normal, as drc render --aovs writes it")
        ->required();
    addImageOutput(*command, options->output);
    command->add_option("--layer", options->layer, "The layer to denoise. Default: the beauty");
    command->add_option("--albedo", options->albedo,
                        fmt::format("The layer of the surfaces' albedo. Default: {}", fmt::join(kAlbedoNames, " or ")));
    command->add_option(
        "--normal", options->normal,
        fmt::format("The layer of the surfaces' normals. Default: {}", fmt::join(kNormalNames, " or ")));
    command->add_option("--quality", options->quality, "high, balanced or fast")
        ->capture_default_str()
        ->check(CLI::IsMember({"high", "balanced", "fast"}));
    command
        ->add_option("--prefilter", options->prefilter,
                     "on: denoise albedo and normal first; off: use them as they are; clean: they have no noise")
        ->capture_default_str()
        ->check(CLI::IsMember({"on", "off", "clean"}));
    command->add_option("--oidn-library", options->library, "As of drc render");
    addThreadsOption(*command, options->threads);
    command->footer(
        "An EXR keeps its other layers as they are. Without albedo and normal, more detail is lost.\n\n"
        "Example: drc image denoise render.exr -o clean.exr");
    command->callback([options, command] { denoise(*options, *command); });
}

}  // namespace drc
