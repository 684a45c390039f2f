#include "image/jpeg_writer.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/folder_testing.h"
#include "image/color.h"
#include "image/jpeg.h"

namespace drc {
namespace {

Image ramp() {
    Image image(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) image.setRgb(x, y, Rgb(float(x) / 48, float(y) / 31, .25f));
    return image;
}

float largestError(int quality) {
    const Image image = ramp();
    const std::string bytes = encodeJpeg(image, quality);
    const Image read = decodeJpeg({bytes, "a.jpg"}).image;
    float largest = 0;
    for (size_t i = 0; i < image.data().size(); ++i)
        largest = std::max(largest, std::abs(read.data()[i] - srgbEncode(clamp01(image.data()[i]))));
    return largest;
}

TEST(JpegWriter, IsSrgbEncodedAndNearTheImage) {
    EXPECT_LT(largestError(100), 4 / 255.f);
    EXPECT_LT(largestError(90), .1f);
    EXPECT_LT(largestError(50), .3f);
}

TEST(JpegWriter, QualityTakesBytes) {
    size_t last = 0;
    for (const int quality : {1, 30, 60, 90, 100}) {
        const size_t size = encodeJpeg(ramp(), quality).size();
        EXPECT_GT(size, last) << quality;
        last = size;
    }
}

TEST(JpegWriter, SaysWhatIsWrong) {
    EXPECT_EQ(errorOf([] { encodeJpeg(Image(), 90, "a.jpg"); }), "cannot write a.jpg: the image is empty");
    EXPECT_EQ(errorOf([] { encodeJpeg(Image(65501, 1), 90, "a.jpg"); }),
              "cannot write a.jpg: the image is 65501x1, and a JPEG has at most 65500 pixels a side");
    // Black where it is no number.
    Image image(8, 8);
    image.data().assign(image.data().size(), std::numeric_limits<float>::quiet_NaN());
    const std::string bytes = encodeJpeg(image, 100);
    const ImageFile read = decodeJpeg({bytes, "a.jpg"});
    for (const float v : read.image.data()) EXPECT_EQ(v, 0);
}

}  // namespace
}  // namespace drc
