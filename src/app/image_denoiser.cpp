#include "app/image_denoiser.h"

#include <fmt/core.h>

#include "app/image_output.h"
#include "base/error.h"
#include "base/log.h"
#include "image/color.h"
#include "image/image_layers.h"

namespace drc {
namespace {

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

OidnSettings settingsOf(const ImageDenoiserOptions& options) {
    return {options.quality == "high"       ? OidnQuality::High
            : options.quality == "balanced" ? OidnQuality::Balanced
                                            : OidnQuality::Fast,
            options.prefilter == "on"      ? OidnAuxiliaries::Prefiltered
            : options.prefilter == "clean" ? OidnAuxiliaries::Clean
                                           : OidnAuxiliaries::Raw};
}

}  // namespace

const std::vector<std::string>& albedoLayerNames() {
    static const std::vector<std::string> names{"Denoising Albedo", "albedo", "Albedo"};
    return names;
}
const std::vector<std::string>& normalLayerNames() {
    static const std::vector<std::string> names{"Denoising Normal", "normal", "Normal", "Ns", "N"};
    return names;
}

ImageDenoiser::ImageDenoiser(ImageDenoiserOptions options)
    : options_(std::move(options)), library_(findOidn(OidnSearch::ofProcess(options_.library))) {}

void ImageDenoiser::denoise(PictureFile& picture, std::optional<Image> given) const {
    Image albedo = findLayer(picture, options_.albedo, albedoLayerNames()),
          normal = findLayer(picture, options_.normal, normalLayerNames());
    const std::string missing = missingGuides(albedo, normal);
    warnOfMissingGuides(picture, missing);
    if (albedo.empty()) normal = {};
    Image colours = given ? std::move(*given) : coloursOf(picture, options_.layer);
    const auto clear = [&](Image& image, const char* name) {
        if (const int64_t bad = clearNonFinite(image); bad > 0)
            logWarning(fmt::format("{}: {} pixel(s) of {} are NaN or infinite; they are taken as black", picture.path,
                                   bad, name));
    };
    clear(colours, "the picture"), clear(albedo, "albedo"), clear(normal, "normal");
    for (float& v : albedo.data()) v = clamp01(v);
    library_.denoise(colours, albedo, normal, settingsOf(options_));
    try {
        setRgbOfLayer(picture.image, layerNamed(picture, options_.layer), colours);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", picture.path, error.what()));
    }
    // The error was that of the picture before denoising.
    picture.metadata.erase("drc:error");
    picture.image = withoutLayers(picture.image, {kErrorLayer});
    picture.metadata["drc:denoiser"] = "oidn " + options_.quality +
                                       (!missing.empty()              ? " without " + missing
                                        : options_.prefilter == "off" ? " without prefilter"
                                                                      : "");
}

}  // namespace drc
