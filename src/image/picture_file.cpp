#include "image/picture_file.h"

#include <algorithm>
#include <cmath>

#include "image/color.h"
#include "image/image_io.h"

namespace drc {
namespace {

void toLinear(Image& image) {
    const int alpha = image.channelIndex("A");
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < image.channels(); ++c)
                if (c != alpha)
                    image.at(x, y, c) = srgbDecode(image.at(x, y, c)) * (alpha < 0 ? 1 : image.at(x, y, alpha));
}

}  // namespace

PictureFile readPictureFile(const std::string& path) {
    ImageFile file = readImageFile(path);
    PictureFile picture{path, std::move(file.image), file.encoding, readMetadata(path), readExrWindow(path)};
    if (file.isSrgbEncoded()) toLinear(picture.image);
    return picture;
}

int64_t clearNonFinite(Image& image) {
    int64_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            float* pixel = image.pixel(x, y);
            const auto isBad = [](float v) { return !std::isfinite(v); };
            count += std::any_of(pixel, pixel + image.channels(), isBad);
            std::replace_if(pixel, pixel + image.channels(), isBad, 0.f);
        }
    return count;
}

}  // namespace drc
