#include "render/oidn_picture_filter.h"

#include <algorithm>

namespace drc {

std::string OidnPictureFilter::name() const {
    const char* quality = settings_.quality == OidnQuality::High       ? " high"
                          : settings_.quality == OidnQuality::Balanced ? " balanced"
                                                                       : " fast";
    return std::string(directAlone_ ? "oidn-direct" : "oidn") + quality +
           (settings_.prefilter ? "" : " without prefilter");
}

void OidnPictureFilter::apply(LayeredPicture& picture) const {
    const GBuffer& g = picture.gBuffer.value();
    if (!directAlone_) {
        picture.beauty = library_.denoised(picture.beauty, g.albedo, g.normal, settings_);
        return;
    }
    Image direct = picture.part("direct");
    for (float& v : direct.data()) v = std::max(v, 0.f);
    // One layer replaces all layers of direct light.
    PictureLayer denoised{"direct", "direct", library_.denoised(direct, g.albedo, g.normal, settings_), std::nullopt};
    std::erase_if(picture.layers, [](const PictureLayer& layer) { return layer.part == "direct"; });
    picture.layers.insert(picture.layers.begin(), std::move(denoised));
    picture.compose();
}

}  // namespace drc
