#include "pbrt/decoded_image.h"

#include "image/image_io.h"

namespace drc::pbrt {
namespace {

DecodedImage colorsOf(const Image& image, bool isSrgbEncoded) {
    DecodedImage result{image.width(), image.height(), {}, isSrgbEncoded};
    result.texels.reserve(image.pixelCount());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) result.texels.push_back(image.rgb(x, y));
    return result;
}

}  // namespace

DecodedImage readAsStored(const std::string& path) {
    const ImageFile file = readImageFile(path);
    return colorsOf(file.image, file.isSrgbEncoded());
}

DecodedImage readLinear(const std::string& path) { return colorsOf(readLinearRgb(path), false); }

}  // namespace drc::pbrt
