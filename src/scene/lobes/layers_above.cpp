#include "scene/lobes/layers_above.h"

namespace drc {

CoatColour::CoatColour(const Rgb& tint, float eta, float share) : inverseEta_(1 / std::max(1.f, eta)), share_(share) {
    // Clamped, since a black tint has an infinite optical depth.
    for (int c = 0; c < 3; ++c) opticalDepth_[c] = -std::log(std::clamp(tint[c], 1e-6f, 1.f));
    clear_ = isBlack(opticalDepth_) || share <= 0;
}

Rgb CoatColour::absorbed(float cosTheta) const {
    const float cosInside = std::max(1e-3f, safeSqrt(1 - sqr(inverseEta_) * (1 - cosTheta * cosTheta)));
    Rgb left;
    for (int c = 0; c < 3; ++c) left[c] = std::exp(-opticalDepth_[c] / cosInside);
    return lerp(share_, Rgb(1.f), left);
}

}  // namespace drc
