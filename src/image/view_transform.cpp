#include "image/view_transform.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "image/color.h"

namespace drc {
namespace {

// Replaces larger radiance, because infinity would give NaN in quotients and differences. Far beyond white in all
// views.
constexpr float kFarBeyondWhite = 1e6f;

float finiteRadiance(float x) { return x > 0 ? std::min(x, kFarBeyondWhite) : 0.f; }

// --- Filmic --------------------------------------------------------------------------------------------------------

float narkowicz(float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

// The radiance that the curve maps to y: the positive root of a quadratic equation.
float inverseNarkowicz(float y) {
    const float a = 2.51f - 2.43f * y, b = 0.03f - 0.59f * y, c = -0.14f * y;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

Rgb filmic(const Rgb& c) {
    static const float scale = inverseNarkowicz(kMiddleGrey) / kMiddleGrey;
    return Rgb(narkowicz(scale * c.x), narkowicz(scale * c.y), narkowicz(scale * c.z));
}

// --- AgX -----------------------------------------------------------------------------------------------------------

// The inset moves every colour by this share towards a weighted mean of its channels, so that in bright, saturated
// colours all channels reach the shoulder of the sigmoid. The weights are those of Sobotka's matrix for Rec. 709.
constexpr float kInset = 0.2f;
const Rgb kInsetWeights(0.2120053548f, 0.3921825078f, 0.3958121374f);

// The range that the sigmoid compresses, in stops about middle grey: log2 of radiance from -12.47 to 4.03.
constexpr float kStopsBelow = 10, kStopsAbove = 6.5f;
constexpr float kSlope = 2.4f, kPower = 1.5f;
// The sigmoid's values are display code values for a display of this exponent.
constexpr float kDisplayExponent = 2.4f;

Rgb inset(const Rgb& c, float share) {
    const float mean = c.x * kInsetWeights.x + c.y * kInsetWeights.y + c.z * kInsetWeights.z;
    return lerp(share, c, Rgb(mean));
}

// A hyperbolic curve with the given slope through the pivot, which reaches 0 and 1 at the ends of [0, 1].
float sigmoid(float x) {
    static const float pivotX = kStopsBelow / (kStopsBelow + kStopsAbove),
                       pivotY = std::pow(kMiddleGrey, 1 / kDisplayExponent);
    const bool isAbove = x > pivotX;
    const float distance = std::abs(x - pivotX);
    // Extent of the curve from the pivot to its end.
    const float run = isAbove ? 1 - pivotX : pivotX, rise = isAbove ? 1 - pivotY : pivotY;
    const float bend = (std::pow(kSlope * run / rise, kPower) - 1) * std::pow(distance / run, kPower);
    const float y = kSlope * distance / std::pow(1 + bend, 1 / kPower);
    return isAbove ? pivotY + y : pivotY - y;
}

float agxCode(float radiance) {
    if (!(radiance > 0)) return 0;
    const float stops = std::log2(radiance / kMiddleGrey);
    return sigmoid(clamp01((stops + kStopsBelow) / (kStopsBelow + kStopsAbove)));
}

Rgb agx(const Rgb& c) {
    const Rgb mixed = inset(c, kInset);
    // The inset preserves the weighted mean, so its inverse for the share s is the inset with the share -s / (1 - s).
    const Rgb code = inset(Rgb(agxCode(mixed.x), agxCode(mixed.y), agxCode(mixed.z)), -kInset / (1 - kInset));
    const auto light = [](float v) { return std::pow(std::max(v, 0.f), kDisplayExponent); };
    return Rgb(light(code.x), light(code.y), light(code.z));
}

}  // namespace

const std::vector<View>& allViews() {
    static const std::vector<View> views{View::Srgb, View::Filmic, View::Agx};
    return views;
}

std::string viewName(View view) { return view == View::Srgb ? "srgb" : view == View::Filmic ? "filmic" : "agx"; }

Rgb viewed(const Rgb& radiance, View view) {
    const Rgb c(finiteRadiance(radiance.x), finiteRadiance(radiance.y), finiteRadiance(radiance.z));
    switch (view) {
        case View::Filmic:
            return clamp01(filmic(c));
        case View::Agx:
            return clamp01(agx(c));
        case View::Srgb:
            break;
    }
    return clamp01(c);
}

Image viewed(const Image& linear, View view, float stops) {
    Image image(linear.width(), linear.height());
    const float factor = std::exp2(stops);
    parallelFor(0, linear.height(), 16, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < linear.width(); ++x) image.setRgb(x, y, viewed(linear.rgb(x, y) * factor, view));
    });
    return image;
}

}  // namespace drc
