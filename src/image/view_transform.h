// View transforms: how linear radiance, which has no upper bound, becomes the light that a display can show.
//
// Grey of 0.18, which photographers call middle grey, stays 0.18 in every view, so that the exposure does not change
// with the view. Greys stay grey.
#pragma once
#include <string>
#include <vector>

#include "image/image.h"

namespace drc {

inline constexpr float kMiddleGrey = 0.18f;

enum class View {
    // Clips at 1. Values within [0, 1] do not change.
    Srgb,
    // Krzysztof Narkowicz' fit of the ACES reference rendering and output transforms ("ACES Filmic Tone Mapping Curve",
    // 2016), for each channel by itself: a toe, and a shoulder that reaches white 5.8 stops above middle grey.
    // Bright colours shift towards the primaries and the mixtures of two primaries.
    Filmic,
    // After Troy Sobotka's AgX (2022): mixes the channels a little, compresses 16.5 stops by a sigmoid, and undoes
    // the mixing. Bright colours pale towards white and keep their hue. The sigmoid is the one that Blender's variant
    // of AgX uses, after Jed Smith.
    Agx
};

// "srgb", "filmic", "agx".
std::string viewName(View view);
const std::vector<View>& allViews();

// The display's linear light in [0, 1], Rec. 709, for exposed linear radiance. Negative values and NaN are black,
// +infinity is white.
Rgb viewed(const Rgb& radiance, View view);

// The first three channels, or grey, times 2^stops, viewed: ready for encodePng. Bits do not depend on the number of
// threads.
Image viewed(const Image& linear, View view, float stops);

}  // namespace drc
