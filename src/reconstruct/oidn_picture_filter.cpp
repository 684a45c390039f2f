#include "reconstruct/oidn_picture_filter.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/log.h"
#include "reconstruct/lattice_denoiser.h"

namespace drc {
namespace {

// Albedo and normal with a standard error of at most this are treated as clean. Compared with prefiltering them, this
// made the error 7 to 71 % larger where their standard error was 0.03 to 0.1, and made no difference where it was 0.017
// (docs/decisions/reconstruction-filters.md).
constexpr float kCleanNoise = 0.02f;

}  // namespace

std::string OidnPictureFilter::name() const {
    const char* quality = settings_.quality == OidnQuality::High       ? " high"
                          : settings_.quality == OidnQuality::Balanced ? " balanced"
                                                                       : " fast";
    return std::string(directAlone_ ? "oidn-direct" : "oidn") + quality +
           (settings_.auxiliaries == OidnAuxiliaries::Raw ? " without prefilter" : "");
}

OidnSettings OidnPictureFilter::settingsFor(const GBuffer& gBuffer) const {
    const bool clean = unlessClean_ && gBuffer.noise <= kCleanNoise;
    return {settings_.quality, clean ? OidnAuxiliaries::Clean : settings_.auxiliaries};
}

void OidnPictureFilter::apply(LayeredPicture& picture) const {
    const GBuffer& g = picture.gBuffer.value();
    const OidnSettings settings = settingsFor(g);
    logDebug(fmt::format("{}: albedo and normal have a standard error of {:.3f} and are taken {}", name(), g.noise,
                         settings.auxiliaries == OidnAuxiliaries::Raw     ? "as they are"
                         : settings.auxiliaries == OidnAuxiliaries::Clean ? "as clean"
                                                                          : "after denoising them"));
    const auto denoise = [&](Image& color) {
        const auto whole = [&](Image& part, const Image& albedo, const Image& normal) {
            library_.denoise(part, albedo, normal, settings, cancel_);
        };
        if (picture.takenAsComplete)
            whole(color, g.albedo, g.normal);
        else
            denoiseByLattices(color, g.albedo, g.normal, *picture.film, whole);
    };
    if (!directAlone_) {
        denoise(picture.beauty);
        return;
    }
    Image direct = picture.part("direct");
    for (float& v : direct.data()) v = std::max(v, 0.f);
    denoise(direct);
    // One layer replaces all layers of direct light.
    PictureLayer denoised{"direct", "direct", std::move(direct), std::nullopt};
    std::erase_if(picture.layers, [](const PictureLayer& layer) { return layer.part == "direct"; });
    picture.layers.insert(picture.layers.begin(), std::move(denoised));
    picture.compose();
}

}  // namespace drc
