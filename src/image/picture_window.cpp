#include "image/picture_window.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "image/encoded_image.h"

namespace drc {

bool isWhole(const Image& image, const ExrWindow& w) {
    return w.fullWidth <= 0 || (w.x == 0 && w.y == 0 && w.fullWidth == image.width() && w.fullHeight == image.height());
}

bool overlaps(const Image& image, const ExrWindow& w) {
    return w.fullWidth <= 0 ||
           (w.x < w.fullWidth && w.y < w.fullHeight && w.x + image.width() > 0 && w.y + image.height() > 0);
}

std::string placeString(const Image& image, const ExrWindow& w) {
    const std::string size = sizeString(image);
    return isWhole(image, w) ? size : fmt::format("{} at ({}, {}) of {}x{}", size, w.x, w.y, w.fullWidth, w.fullHeight);
}

void requireSamePlace(const PlacedPicture& first, const PlacedPicture& other, const std::string& what) {
    const ExrWindow &a = first.window, &b = other.window;
    const bool areOfOneSize =
        first.image.width() == other.image.width() && first.image.height() == other.image.height();
    const bool areKnown = a.fullWidth > 0 && b.fullWidth > 0;
    const bool areAtOnePlace = a.x == b.x && a.y == b.y && a.fullWidth == b.fullWidth && a.fullHeight == b.fullHeight;
    if (areOfOneSize && (!areKnown || areAtOnePlace)) return;
    const bool isPart = !isWhole(first.image, a) || !isWhole(other.image, b);
    throw Error(fmt::format("{} is {}, but {} is {}: only pictures of {} can be {}", other.path,
                            placeString(other.image, b), first.path, placeString(first.image, a),
                            isPart ? "the same part of one whole" : "one size", what));
}

Image placedInWindow(const Image& image, const ExrWindow& w, const std::string& path) {
    if (isWhole(image, w)) return image;
    const MemoryClaim memory = claimMemory({{}, path}, w.fullWidth, w.fullHeight, image.channels());
    Image whole(w.fullWidth, w.fullHeight, image.channelNames());
    const int x0 = std::max(0, w.x), x1 = std::min(w.fullWidth, w.x + image.width());
    const int y0 = std::max(0, w.y), y1 = std::min(w.fullHeight, w.y + image.height());
    if (x0 < x1)
        for (int y = y0; y < y1; ++y)
            std::copy_n(image.pixel(x0 - w.x, y - w.y), size_t(x1 - x0) * size_t(image.channels()), whole.pixel(x0, y));
    return whole;
}

}  // namespace drc
