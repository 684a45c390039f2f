#include "pbrt/decoded_image.h"

#include "image/image_io.h"

namespace drc::pbrt {
namespace {

DecodedImage colorsOf(const Image& image) {
    DecodedImage result{image.width(), image.height(), {}};
    result.texels.reserve(image.pixelCount());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) result.texels.push_back(image.rgb(x, y));
    return result;
}

}  // namespace

DecodedImage readAsStored(const std::string& path) { return colorsOf(readTextureFile(path).image); }

DecodedImage readLinear(const std::string& path) { return colorsOf(linearRgbOf(readTextureFile(path))); }

}  // namespace drc::pbrt
