#include "image/difference_image.h"

#include "image/color.h"
#include "image/metrics.h"

namespace drc {
namespace {

constexpr float kGain = 4;

}  // namespace

Image differenceImage(const Image& reference, const Image& test, float exposure) {
    requireSameSize(reference, test);
    const Image r = exposed(reference, exposure), t = exposed(test, exposure);
    const int width = r.width(), height = r.height();
    Image picture(4 * width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Rgb cr = clamp01(r.rgb(x, y)), ct = clamp01(t.rgb(x, y));
            const Rgb d = (srgbEncode(ct) - srgbEncode(cr)) * kGain;
            const float s = luminance(d);
            picture.setRgb(x, y, cr);
            picture.setRgb(width + x, y, ct);
            // Decoded, since writing the PNG encodes again, and the PNG should contain the difference itself.
            picture.setRgb(2 * width + x, y, srgbDecode(clamp01(Rgb(std::abs(d.x), std::abs(d.y), std::abs(d.z)))));
            picture.setRgb(3 * width + x, y, srgbDecode(clamp01(Rgb(s, 0, -s))));
        }
    }
    return picture;
}

}  // namespace drc
