#include "pbrt/mean_or_alpha.h"

#include <algorithm>

namespace drc::pbrt {
namespace {

// An image of one channel with the value numberOf(x, y) at each pixel.
template <typename F>
Image ofNumbers(const Image& image, const F& numberOf) {
    Image numbers(image.width(), image.height(), {"Y"});
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) numbers.at(x, y, 0) = numberOf(x, y);
    return numbers;
}

template <typename F>
bool isTrueOfAll(const Image& image, const F& isTrueAt) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (!isTrueAt(x, y)) return false;
    return true;
}

}  // namespace

Image meanOrAlpha(const Image& image, TexelEncoding& encoding) {
    // EXR files may store their channels in alphabetical order.
    const int red = image.channelIndex("R"), green = image.channelIndex("G"), blue = image.channelIndex("B");
    const bool named = red >= 0 && green >= 0 && blue >= 0;
    const auto colorAt = [&](int x, int y) {
        return named ? Rgb(image.at(x, y, red), image.at(x, y, green), image.at(x, y, blue)) : image.rgb(x, y);
    };
    if (image.channels() < 3) return ofNumbers(image, [&](int x, int y) { return image.at(x, y, 0); });
    const int alpha = image.channelIndex("A");
    if (alpha >= 0 && !isTrueOfAll(image, [&](int x, int y) { return image.at(x, y, alpha) == 1; }))
        return ofNumbers(image, [&](int x, int y) { return image.at(x, y, alpha); });
    const auto isGrey = [&](int x, int y) {
        const Rgb c = colorAt(x, y);
        return c.x == c.y && c.y == c.z;
    };
    // Grey images keep their encoding, which needs the least memory.
    if (isTrueOfAll(image, isGrey)) return ofNumbers(image, [&](int x, int y) { return colorAt(x, y).x; });
    const bool srgb = encoding == TexelEncoding::Srgb;
    encoding = TexelEncoding::Linear;
    return ofNumbers(image, [&](int x, int y) {
        const Rgb c = colorAt(x, y);
        return srgb ? (srgbToLinear(c.x) + srgbToLinear(c.y) + srgbToLinear(c.z)) / 3 : (c.x + c.y + c.z) / 3;
    });
}

}  // namespace drc::pbrt
