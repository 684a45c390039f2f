#include "image/radiance_hdr_writer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "base/folder_testing.h"
#include "image/radiance_hdr.h"

namespace drc {
namespace {

Image readBack(const Image& image) {
    const std::string bytes = encodeRadianceHdr(image);
    return decodeRadianceHdr({bytes, "a.hdr"}).image;
}

TEST(RadianceHdrWriter, IsWithinTheFormatsPrecision) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-100, 100), mantissa(.5f, 1);
    // Narrow rows have no runs; the widest ones neither.
    for (const int width : {1, 7, 8, 200, 32767, 32768}) {
        Image image(width, 2);
        for (float& v : image.data()) v = std::exp2(exponent(random)) * mantissa(random);
        for (int x = width / 3; x < width / 2; ++x) image.setRgb(x, 0, Rgb(1, 2, 3));
        const Image read = readBack(image);
        ASSERT_EQ(sizeString(read), sizeString(image));
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < width; ++x) {
                const Rgb c = image.rgb(x, y), r = read.rgb(x, y);
                const float largest = std::max({c.x, c.y, c.z});
                for (int i = 0; i < 3; ++i) ASSERT_NEAR(r[i], c[i], largest * 1.001f / 256) << width << " " << x;
            }
    }
}

TEST(RadianceHdrWriter, SmallNumbersOfBitsAreExact) {
    Image image(3, 1);
    image.data() = {1, 2, 3, .5f, .25f, 0, 255, 100, 1};
    EXPECT_EQ(readBack(image).data(), image.data());
}

TEST(RadianceHdrWriter, EqualPixelsTakeFewBytes) {
    Image image(1000, 10);
    for (float& v : image.data()) v = .3f;
    EXPECT_LT(encodeRadianceHdr(image).size(), 1000u);
}

TEST(RadianceHdrWriter, WhatTheFormatHasNotIsClamped) {
    Image image(4, 1);
    image.setRgb(0, 0, Rgb(-1, 2, std::numeric_limits<float>::quiet_NaN()));
    image.setRgb(1, 0, Rgb(kInfinity, 0, 0));
    image.setRgb(2, 0, Rgb(1e-39f));
    image.setRgb(3, 0, Rgb(.9999f, 0, 0));  // its mantissa is 256, rounded
    const Image read = readBack(image);
    EXPECT_EQ(read.rgb(0, 0), Rgb(0, 2, 0));
    EXPECT_GT(read.rgb(1, 0).x, 1e38f);
    EXPECT_TRUE(std::isfinite(read.rgb(1, 0).x));
    EXPECT_EQ(read.rgb(2, 0), Rgb(0.f));
    EXPECT_EQ(read.rgb(3, 0).x, 1);
    EXPECT_EQ(errorOf([] { encodeRadianceHdr(Image(), "a.hdr"); }), "cannot write a.hdr: the image is empty");
}

}  // namespace
}  // namespace drc
