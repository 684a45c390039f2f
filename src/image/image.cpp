#include "image/image.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "base/error.h"

namespace drc {

Image::Image(int width, int height, std::vector<std::string> channelNames)
    : width_(width), height_(height), names_(std::move(channelNames)) {
    if (width <= 0 || height <= 0) throw Error(fmt::format("an image cannot have the size {}x{}", width, height));
    if (names_.empty()) throw Error("an image needs at least one channel");
    std::set<std::string> seen;
    for (const auto& name : names_)
        if (!seen.insert(name).second) throw Error(fmt::format("two channels of an image are called {}", name));
    data_.resize(pixelCount() * names_.size());
}

int Image::channelIndex(const std::string& name) const {
    const auto it = std::find(names_.begin(), names_.end(), name);
    return it == names_.end() ? -1 : static_cast<int>(it - names_.begin());
}

Image Image::crop(int x0, int y0, int x1, int y1) const {
    if (x0 < 0 || y0 < 0 || x1 > width_ || y1 > height_ || x0 >= x1 || y0 >= y1)
        throw Error(fmt::format("cannot cut x {} to {}, y {} to {} out of an image of {}x{} pixels", x0, x1, y0, y1,
                                width_, height_));
    Image part(x1 - x0, y1 - y0, names_);
    for (int y = y0; y < y1; ++y) std::copy_n(pixel(x0, y), size_t(x1 - x0) * names_.size(), part.pixel(0, y - y0));
    return part;
}

Image Image::toRgb() const {
    Image result(width_, height_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) result.setRgb(x, y, rgb(x, y));
    return result;
}

std::string sizeString(const Image& image) { return fmt::format("{}x{}", image.width(), image.height()); }

void requireSameSize(const Image& reference, const Image& test) {
    if (reference.width() != test.width() || reference.height() != test.height())
        throw Error(fmt::format("the images differ in size: the reference is {}, the test image is {}",
                                sizeString(reference), sizeString(test)));
    if (reference.empty()) throw Error("the images to compare are empty");
}

}  // namespace drc
