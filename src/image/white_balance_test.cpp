#include "image/white_balance.h"

#include <gtest/gtest.h>

#include "image/color.h"

namespace drc {
namespace {

void expectNear(const Rgb& a, const Rgb& b, float tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << a << " " << b;
}

TEST(WhiteBalance, TheLightBecomesGreyOfItsLuminance) {
    for (const Rgb& light : {Rgb(1, 0.6f, 0.2f), Rgb(3, 4, 7), Rgb(0.02f, 0.02f, 0.02f)})
        expectNear(whiteBalance(light) * light, Rgb(luminance(light)), 2e-4f * luminance(light));
}

TEST(WhiteBalance, UnderD65NothingChanges) {
    const RgbMatrix m = whiteBalance(Rgb(1.f));
    for (const Rgb& c : {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)}) expectNear(m * c, c, 2e-5f);
    // Of which the locus of daylight passes close by.
    expectNear(daylight(6504), Rgb(1.f), 0.01f);
}

// Chromaticities of the CIE's tables, at the temperatures of D50 and D75.
TEST(WhiteBalance, DaylightIsTheCies) {
    const struct {
        float kelvin, x, y;
    } cases[] = {{5003, 0.34567f, 0.35851f}, {7504, 0.29902f, 0.31485f}, {4000, 0.38234f, 0.38377f}};
    for (const auto& c : cases) {
        const Vec3 xyz = rgbToXyz(daylight(c.kelvin));
        EXPECT_NEAR(xyz.y, 1, 1e-5);
        EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), c.x, 2e-4) << c.kelvin;
        EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), c.y, 2e-4) << c.kelvin;
    }
}

// Bradford's matrix from D50 to D65, as published for XYZ (B. Lindbloom, "Chromatic Adaptation").
TEST(WhiteBalance, IsBradfordsAdaptation) {
    const Vec3 d50(0.96422f, 1, 0.82521f);
    const RgbMatrix m = whiteBalance(xyzToRgb(d50));
    const Vec3 in(0.3f, 0.4f, 0.2f);
    const Vec3 expected(0.9555766f * 0.3f - 0.0230393f * 0.4f + 0.0631636f * 0.2f,
                        -0.0282895f * 0.3f + 1.0099416f * 0.4f + 0.0210077f * 0.2f,
                        0.0122982f * 0.3f - 0.0204830f * 0.4f + 1.3299098f * 0.2f);
    const Vec3 out = rgbToXyz(m * xyzToRgb(in));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(out[i], expected[i], 3e-4) << i;
}

TEST(WhiteBalance, VarianceIsABoundThatFullCorrelationReaches) {
    const RgbMatrix m{{Vec3(2, 0, 0), Vec3(0.5f, 1, 0), Vec3(0, -1, 1)}};
    expectNear(m.ofVariance(Rgb(1, 4, 9)), Rgb(4, 6.25f, 25), 1e-5f);
}

}  // namespace
}  // namespace drc
