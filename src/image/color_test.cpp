#include "image/color.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Color, SrgbTransferFunction) {
    EXPECT_EQ(srgbEncode(0.f), 0.f);
    EXPECT_NEAR(srgbEncode(1.f), 1, 1e-6);
    EXPECT_NEAR(srgbEncode(0.18f), 0.461356, 1e-5);
    EXPECT_NEAR(srgbDecode(0.5f), 0.214041, 1e-6);
    EXPECT_NEAR(srgbEncode(0.002f), 0.02584, 1e-6);
    for (float x = -2; x < 2; x += 0.01f) EXPECT_NEAR(srgbDecode(srgbEncode(x)), x, 2e-5f);
}

TEST(Color, Bytes) {
    EXPECT_EQ(toByte(-1), 0);
    EXPECT_EQ(toByte(0.5f), 128);
    EXPECT_EQ(toByte(1), 255);
    EXPECT_EQ(toByte(kInfinity), 255);
    EXPECT_EQ(toByte(std::numeric_limits<float>::quiet_NaN()), 0);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(toByte(srgbEncode(srgbDecode(float(i) / 255))), i);
}

TEST(Color, XyzAndLab) {
    EXPECT_NEAR(kWhiteXyz.x, 0.95047, 1e-4);
    EXPECT_NEAR(kWhiteXyz.y, 1, 1e-6);
    EXPECT_NEAR(kWhiteXyz.z, 1.08883, 1e-3);
    const Rgb c(.2f, .7f, .4f), back = xyzToRgb(rgbToXyz(c));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], c[i], 1e-5);
    const Vec3 white = rgbToLab(Rgb(1, 1, 1)), grey = rgbToLab(Rgb(.18f, .18f, .18f)), green = rgbToLab(Rgb(0, 1, 0));
    EXPECT_NEAR(white.x, 100, 1e-3);
    EXPECT_NEAR(white.y, 0, 1e-3);
    EXPECT_NEAR(grey.x, 49.496, 1e-2);
    // Lindbloom's calculator: sRGB green is (87.73, -86.18, 83.18) relative to D65.
    EXPECT_NEAR(green.x, 87.73, 0.05);
    EXPECT_NEAR(green.y, -86.18, 0.1);
    EXPECT_NEAR(green.z, 83.18, 0.1);
}

}  // namespace
}  // namespace drc
