#include "app/map_pictures.h"

#include <algorithm>
#include <cmath>

#include "image/color.h"

namespace drc {
namespace {

const Rgb kEscaped = srgbDecode(Rgb(0.22f, 0.36f, 0.55f));

// The colours of errors from 0 to 1, sRGB-encoded, evenly spaced, with equal steps in lightness.
const Rgb kErrorColours[] = {Rgb(0, 0, 0.02f),         Rgb(0.21f, 0.05f, 0.38f), Rgb(0.50f, 0.12f, 0.42f),
                             Rgb(0.78f, 0.24f, 0.32f), Rgb(0.95f, 0.46f, 0.13f), Rgb(0.98f, 0.74f, 0.20f),
                             Rgb(0.99f, 0.99f, 0.75f)};

Rgb falseColour(float x) {
    constexpr int kLast = int(std::size(kErrorColours)) - 1;
    const float place = clamp01(x) * kLast;
    const int i = std::min(int(place), kLast - 1);
    const float t = place - float(i);
    return srgbDecode(kErrorColours[i] * (1 - t) + kErrorColours[i + 1] * t);
}

template <typename F>
Image picture(const MapLayout& layout, const F& colourOf) {
    Image result(layout.size(), layout.size());
    for (int i = 0; i < layout.texels(); ++i) result.setRgb(i % layout.size(), i / layout.size(), colourOf(size_t(i)));
    return result;
}

Rgb planar(std::span<const float> values, size_t texel) {
    const size_t texels = values.size() / 3;
    return Rgb(values[texel], values[texels + texel], values[2 * texels + texel]);
}

}  // namespace

Image radiancePicture(std::span<const float> radiance, const MapLayout& layout, float exposure) {
    return picture(layout, [&](size_t i) { return clamp01(planar(radiance, i) * exposure); });
}

Image distancePicture(const CapturedMap& map, const MapLayout& layout) {
    float nearest = kInfinity, farthest = 0;
    for (const float d : map.distance)
        if (d > 0) nearest = std::min(nearest, d), farthest = std::max(farthest, d);
    const float range = std::max(std::log(farthest / nearest), 1e-3f);
    return picture(layout, [&](size_t i) {
        const float d = map.distance[i];
        if (d < 0) return kEscaped;
        return srgbDecode(Rgb(d > 0 ? 0.1f + 0.9f * std::log(d / nearest) / range : 0.1f));
    });
}

Image normalPicture(const CapturedMap& map, const MapLayout& layout) {
    return picture(layout, [&](size_t i) {
        const Vec3 n = planar(map.normal, i);
        return n == Vec3(0.f) ? Rgb(0.f) : srgbDecode(clamp01(Rgb(0.5f) + 0.5f * n));
    });
}

std::vector<float> texelErrors(std::span<const float> radiance, std::span<const float> target, float unit) {
    std::vector<float> errors(radiance.size() / 3);
    for (size_t i = 0; i < radiance.size(); ++i)
        errors[i % errors.size()] += std::abs(radiance[i] - target[i]) / (3 * unit);
    return errors;
}

Image errorPicture(std::span<const float> errors, const MapLayout& layout, float white) {
    return picture(layout, [&](size_t i) { return falseColour(errors[i] / white); });
}

Image errorScale() {
    Image scale(256, 1);
    for (int x = 0; x < 256; ++x) scale.setRgb(x, 0, falseColour(float(x) / 255));
    return scale;
}

}  // namespace drc
