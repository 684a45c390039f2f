#include "scene/textures/mip_pyramid.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"

namespace drc {
namespace {

Image image(int width, int height, auto value) {
    Image result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) result.setRgb(x, y, value(x, y));
    return result;
}

Image noise(int width, int height, bool eightBit) {
    std::mt19937 rng(1);
    return image(width, height, [&](int, int) {
        Rgb c;
        for (int k = 0; k < 3; ++k) c[k] = eightBit ? float(rng() % 256) / 255 : float(rng() % 65536) / 30000;
        return c;
    });
}

TEST(MipPyramid, RowZeroIsAtTheTop) {
    const RgbPyramid p(image(2, 2, [](int x, int y) { return Rgb(float(x), float(y), 0.3f); }), TexelEncoding::Linear);
    // t = 0.25 is the centre of the bottom row, which is row 1.
    EXPECT_EQ(p.lookup(Vec2(0.25f, 0.25f), 0, ImageWrap::Clamp), Rgb(0, 1, 0.3f));
    EXPECT_EQ(p.lookup(Vec2(0.75f, 0.75f), 0, ImageWrap::Clamp), Rgb(1, 0, 0.3f));
    EXPECT_NEAR(p.lookup(Vec2(0.5f, 0.25f), 0, ImageWrap::Clamp).x, 0.5f, 1e-6f);
}

TEST(MipPyramid, Wraps) {
    const FloatPyramid p(image(4, 1, [](int x, int) { return Rgb(float(x + 1)); }), TexelEncoding::Linear);
    const auto at = [&](float s, float t, ImageWrap w) { return p.lookup(Vec2(s, t), 0, w); };
    EXPECT_NEAR(at(1.125f, 0.5f, ImageWrap::Repeat), 1, 1e-5f);
    EXPECT_NEAR(at(-0.125f, 7.5f, ImageWrap::Repeat), 4, 1e-5f);
    EXPECT_NEAR(at(0, 0.5f, ImageWrap::Repeat), 2.5f, 1e-5f);
    EXPECT_NEAR(at(-3, 0.5f, ImageWrap::Clamp), 1, 1e-5f);
    EXPECT_NEAR(at(9, 0.5f, ImageWrap::Clamp), 4, 1e-5f);
    EXPECT_NEAR(at(0, 0.5f, ImageWrap::Black), 0.5f, 1e-5f);
    EXPECT_EQ(at(1.5f, 0.5f, ImageWrap::Black), 0);
    EXPECT_EQ(at(1e30f, 0.5f, ImageWrap::Black), 0);
    EXPECT_TRUE(std::isfinite(at(std::nanf(""), kInfinity, ImageWrap::Repeat)));
}

TEST(MipPyramid, EveryLevelKeepsTheMean) {
    for (const auto& [w, h] : {std::pair(64, 64), std::pair(37, 53), std::pair(5, 1), std::pair(3, 130)}) {
        const Image source = noise(w, h, false);
        Rgb mean(0.f);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) mean += source.rgb(x, y) * (1.f / float(w * h));
        const RgbPyramid p(source, TexelEncoding::Linear);
        const Rgb top = p.lookup(Vec2(0.1f, 0.2f), 10, ImageWrap::Repeat);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(top[k], mean[k], 1e-4f) << w << "x" << h;
    }
}

TEST(MipPyramid, WidthChoosesTheLevel) {
    // Stripes one texel wide have full contrast at the finest level, and hardly any at a width of a quarter.
    const FloatPyramid p(image(16, 16, [](int x, int) { return Rgb(float(x % 2)); }), TexelEncoding::Linear);
    EXPECT_EQ(p.levels(), 5);
    const Vec2 st(1.5f / 16, 0.5f);
    EXPECT_NEAR(p.lookup(st, 0, ImageWrap::Repeat), 1, 1e-5f);
    EXPECT_NEAR(p.lookup(st, 1.f / 16, ImageWrap::Repeat), 1, 1e-5f);
    EXPECT_NEAR(p.lookup(st, std::sqrt(2.f) / 16, ImageWrap::Repeat), 0.75f, 1e-3f);
    EXPECT_NEAR(p.lookup(st, 2.f / 16, ImageWrap::Repeat), 0.5f, 1e-3f);
}

// Compares with the mean of many lookups at the finest level over the ellipse.
TEST(MipPyramid, FiltersOverAnEllipse) {
    // Waves with a period of 8 texels along x and 16 along y.
    const auto wave = [](int k, float period) { return 0.5f + 0.5f * std::sin(2 * kPi * (float(k) + 0.5f) / period); };
    const FloatPyramid p(image(64, 32, [&](int x, int y) { return Rgb(wave(x, 8) * wave(y, 16)); }),
                         TexelEncoding::Linear);
    const Vec2 st(0.37f, 0.71f);
    for (const auto& [axis0, axis1] :
         {std::pair(Vec2(12.f / 64, 0), Vec2(0, 1.f / 32)), std::pair(Vec2(0, 12.f / 32), Vec2(1.f / 64, 0)),
          std::pair(Vec2(7.f / 64, 5.f / 32), Vec2(-0.5f / 64, 0.7f / 32)),
          std::pair(Vec2(5.f / 64, 5.f / 32), Vec2(5.f / 64, 3.5f / 32)), std::pair(Vec2(0, 0), Vec2(6.f / 64, 0))}) {
        float mean = 0;
        int count = 0;
        for (float x = -0.5f; x <= 0.5f; x += 0.02f)
            for (float y = -0.5f; y <= 0.5f; y += 0.02f) {
                if (x * x + y * y > 0.25f) continue;
                mean += p.lookup(st + axis0 * x + axis1 * y, 0, ImageWrap::Repeat);
                ++count;
            }
        mean /= float(count);
        EXPECT_NEAR(p.lookup(st, axis0, axis1, 16, ImageWrap::Repeat), mean, 0.08f) << axis0 << axis1;
    }
}

TEST(MipPyramid, LongEllipsesAreNeitherBlurredAcrossNorLetThroughAlong) {
    // Stripes of four texels across s: an ellipse along t keeps them, an ellipse along s removes them.
    const FloatPyramid p(image(64, 64, [](int x, int) { return Rgb(float(x / 4 % 2)); }), TexelEncoding::Linear);
    const Vec2 st(6.f / 64, 0.5f), alongS(16.f / 64, 0), alongT(0, 16.f / 64), across(1.f / 64, 0);
    EXPECT_NEAR(p.lookup(st, alongT, across, 16, ImageWrap::Repeat), 1, 1e-4f);
    EXPECT_NEAR(p.lookup(st, across, alongT, 16, ImageWrap::Repeat), 1, 1e-4f);
    EXPECT_NEAR(p.lookup(st, alongS, Vec2(0, 1.f / 64), 16, ImageWrap::Repeat), 0.5f, 0.06f);
    // With maxAnisotropy 1, the filter is as wide as the ellipse is long.
    EXPECT_NEAR(p.lookup(st, alongT, across, 1, ImageWrap::Repeat), 0.5f, 1e-3f);
}

TEST(MipPyramid, RoundEllipsesAreTrilinearLookups) {
    const RgbPyramid p(noise(32, 32, true), TexelEncoding::Linear);
    for (const float width : {0.f, 0.01f, 0.1f, 0.3f, 5.f}) {
        const Vec2 st(0.3f, 0.8f), a = Vec2(0.6f, 0.8f) * width, b = Vec2(-0.8f, 0.6f) * width;
        const Rgb round = p.lookup(st, a, b, 8, ImageWrap::Repeat), one = p.lookup(st, width, ImageWrap::Repeat);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(round[k], one[k], 1e-3f) << width;
    }
    const Vec2 nothing(std::nanf(""), 0);
    EXPECT_TRUE(isFinite(p.lookup(Vec2(0.5f, 0.5f), nothing, nothing, 8, ImageWrap::Repeat)));
    EXPECT_TRUE(isFinite(p.lookup(Vec2(0.5f, 0.5f), Vec2(kInfinity, 0), Vec2(0, 1), 8, ImageWrap::Repeat)));
}

TEST(MipPyramid, EightBitImagesAreKeptSmallAndExact) {
    const Image source = noise(64, 32, true);
    const RgbPyramid p(source, TexelEncoding::Linear);
    EXPECT_LT(p.bytes(), 64u * 32 * 6);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const Vec2 st((x + 0.5f) / 64, 1 - (y + 0.5f) / 32);
            const Rgb c = p.lookup(st, 0, ImageWrap::Repeat);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(c[k], source.at(x, y, k), 1e-4f);
        }
    // The same image, already linearised by the reader.
    Image linear = source;
    for (float& v : linear.data()) v = srgbToLinear(v);
    const RgbPyramid q(linear, TexelEncoding::Linear), r(source, TexelEncoding::Srgb);
    EXPECT_EQ(q.bytes(), p.bytes());
    for (float s = 0; s < 1; s += 0.07f)
        for (const float width : {0.f, 0.1f})
            EXPECT_LT(
                length(q.lookup(Vec2(s, s), width, ImageWrap::Repeat) - r.lookup(Vec2(s, s), width, ImageWrap::Repeat)),
                1e-5f);
    // Other images are not quantised.
    EXPECT_GE(RgbPyramid(noise(64, 32, false), TexelEncoding::Linear).bytes(), 64u * 32 * 12);
}

TEST(MipPyramid, Srgb) {
    EXPECT_NEAR(srgbToLinear(0.5f), 0.2140411f, 1e-6f);
    EXPECT_NEAR(srgbToLinear(0.02f), 0.02f / 12.92f, 1e-8f);
    const FloatPyramid p(image(1, 1, [](int, int) { return Rgb(0.5f); }), TexelEncoding::Srgb);
    EXPECT_NEAR(p.lookup(Vec2(0.5f, 0.5f), 0, ImageWrap::Repeat), 0.2140411f, 1e-6f);
}

TEST(MipPyramid, RefusesAnEmptyImage) { EXPECT_THROW(RgbPyramid(Image(), TexelEncoding::Linear), Error); }

}  // namespace
}  // namespace drc
