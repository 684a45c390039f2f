#include "render/oidn_picture_filter.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/log.h"

namespace drc {
namespace {

// A G-buffer is clean if at most this share of its pixels is noisy.
constexpr float kCleanShare = 0.25f;

}  // namespace

std::string OidnPictureFilter::name() const {
    const char* quality = settings_.quality == OidnQuality::High       ? " high"
                          : settings_.quality == OidnQuality::Balanced ? " balanced"
                                                                       : " fast";
    return std::string(directAlone_ ? "oidn-direct" : "oidn") + quality +
           (settings_.auxiliaries == OidnAuxiliaries::Raw ? " without prefilter" : "");
}

OidnSettings OidnPictureFilter::settingsFor(const GBuffer& gBuffer) const {
    const bool clean = unlessClean_ && gBuffer.noisyShare <= kCleanShare;
    return {settings_.quality, clean ? OidnAuxiliaries::Clean : settings_.auxiliaries};
}

void OidnPictureFilter::apply(LayeredPicture& picture) const {
    const GBuffer& g = picture.gBuffer.value();
    const OidnSettings settings = settingsFor(g);
    logDebug(fmt::format("{}: albedo and normal are noisy in {:.0f} % of the pixels, and taken {}", name(),
                         100 * g.noisyShare,
                         settings.auxiliaries == OidnAuxiliaries::Raw     ? "as they are"
                         : settings.auxiliaries == OidnAuxiliaries::Clean ? "as clean"
                                                                          : "after denoising them"));
    if (!directAlone_) {
        library_.denoise(picture.beauty, g.albedo, g.normal, settings);
        return;
    }
    Image direct = picture.part("direct");
    for (float& v : direct.data()) v = std::max(v, 0.f);
    library_.denoise(direct, g.albedo, g.normal, settings);
    // One layer replaces all layers of direct light.
    PictureLayer denoised{"direct", "direct", std::move(direct), std::nullopt};
    std::erase_if(picture.layers, [](const PictureLayer& layer) { return layer.part == "direct"; });
    picture.layers.insert(picture.layers.begin(), std::move(denoised));
    picture.compose();
}

}  // namespace drc
