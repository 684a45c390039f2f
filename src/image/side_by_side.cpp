#include "image/side_by_side.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/limits.h"
#include "base/memory.h"

namespace drc {
namespace {

const Rgb kWhite(1);

void requireOneSize(const std::vector<Image>& images) {
    if (images.empty()) throw Error("there are no pictures to show side by side");
    for (const Image& image : images)
        if (image.width() != images[0].width() || image.height() != images[0].height())
            throw Error(fmt::format("the pictures differ in size: the first is {}, another is {}",
                                    sizeString(images[0]), sizeString(image)));
}

}  // namespace

Image strips(const std::vector<Image>& images, bool rows, int line) {
    requireOneSize(images);
    const int width = images[0].width(), height = images[0].height(), count = int(images.size());
    const int length = rows ? height : width;
    if (count > length) throw Error(fmt::format("{} strips do not fit on {} pixels", count, length));
    // For each pixel along the length: the index of the picture that it shows, or -1 for a line.
    std::vector<int> shown(size_t(length), 0);
    for (int i = 0; i < length; ++i) shown[size_t(i)] = int(int64_t(i) * count / length);
    for (int strip = 1; strip < count; ++strip) {
        const int border = int((int64_t(strip) * length + count - 1) / count);
        for (int i = border - line / 2; i < border - line / 2 + line; ++i)
            if (i >= 0 && i < length) shown[size_t(i)] = -1;
    }
    Image result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int i = shown[size_t(rows ? y : x)];
            result.setRgb(x, y, i < 0 ? kWhite : images[size_t(i)].rgb(x, y));
        }
    return result;
}

Image cutOuts(const std::vector<Image>& images, const std::vector<PixelRect>& parts, int zoom, int gap) {
    requireOneSize(images);
    if (parts.empty()) throw Error("there is no part to cut out");
    const int width = parts[0].x1 - parts[0].x0, height = parts[0].y1 - parts[0].y0;
    for (const PixelRect& part : parts) {
        if (part.x0 < 0 || part.y0 < 0 || part.x1 > images[0].width() || part.y1 > images[0].height() ||
            part.x0 >= part.x1 || part.y0 >= part.y1)
            throw Error(fmt::format("cannot cut x {} to {}, y {} to {} out of pictures of {} pixels", part.x0, part.x1,
                                    part.y0, part.y1, sizeString(images[0])));
        if (part.x1 - part.x0 != width || part.y1 - part.y0 != height)
            throw Error(fmt::format("the parts differ in size: the first is {}x{}, another is {}x{}", width, height,
                                    part.x1 - part.x0, part.y1 - part.y0));
    }
    const auto side = [&](int length, size_t count) {
        return int64_t(length) * zoom * int64_t(count) + int64_t(gap) * (int64_t(count) - 1);
    };
    const int64_t wide = side(width, images.size()), high = side(height, parts.size());
    if (wide > limits::kImageSide || high > limits::kImageSide)
        throw Error(
            fmt::format("the picture would have {}x{} pixels; at most {} a side", wide, high, limits::kImageSide));
    const MemoryClaim memory(double(wide) * double(high) * sizeof(Rgb),
                             fmt::format("a picture of {}x{} pixels", wide, high));
    Image result{int(wide), int(high)};
    for (float& v : result.data()) v = 1;
    for (size_t row = 0; row < parts.size(); ++row)
        for (size_t column = 0; column < images.size(); ++column) {
            const int left = int(column) * (width * zoom + gap), top = int(row) * (height * zoom + gap);
            for (int y = 0; y < height * zoom; ++y)
                for (int x = 0; x < width * zoom; ++x)
                    result.setRgb(left + x, top + y,
                                  images[column].rgb(parts[row].x0 + x / zoom, parts[row].y0 + y / zoom));
        }
    return result;
}

}  // namespace drc
