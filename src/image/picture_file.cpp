#include "image/picture_file.h"

#include <algorithm>
#include <cmath>

#include "image/image_io.h"
#include "image/image_layers.h"

namespace drc {
namespace {

void toLinear(ImageFile& file) {
    Image& image = file.image;
    const int alpha = image.channelIndex("A");
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < image.channels(); ++c)
                if (c != alpha)
                    image.at(x, y, c) = decodedValue(file, image.at(x, y, c)) * (alpha < 0 ? 1 : image.at(x, y, alpha));
}

}  // namespace

PictureFile readPictureFile(const std::string& path) {
    ImageFile file = readImageFile(path);
    if (file.isSrgbEncoded()) toLinear(file);
    return {path,
            std::move(file.image),
            file.encoding,
            readMetadata(path),
            file.window,
            std::move(file.storage),
            std::move(file.beautyPart)};
}

std::string layerNamed(const PictureFile& picture, const std::string& name) {
    const std::vector<std::string> layers = layerNames(picture.image);
    const auto isLayer = [&](const std::string& of) {
        return std::find(layers.begin(), layers.end(), of) != layers.end();
    };
    if (picture.beautyPart.empty() || isLayer(name)) return name;
    if (name == picture.beautyPart) return "";
    const std::string prefix = picture.beautyPart + ".",
                      rest = name.starts_with(prefix) ? name.substr(prefix.size()) : "";
    return !rest.empty() && (isLayer(rest) || picture.image.channelIndex(rest) >= 0) ? rest : name;
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
