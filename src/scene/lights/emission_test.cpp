#include "scene/lights/emission.h"

#include <gtest/gtest.h>

#include "math/rng.h"

namespace drc {
namespace {

LightImage noise(int width, int height, bool repeats) {
    LightImage image{width, height, {}, repeats};
    Pcg32 rng(3);
    for (int i = 0; i < width * height; ++i) {
        const float value = rng.nextFloat();
        image.texels.push_back(value < 0.9f ? Rgb(0.f) : Rgb(value, 0.5f * value, rng.nextFloat()));
    }
    return image;
}

TEST(EmissionImage, LooksUpFromTheCornerOfRow0) {
    const EmissionImage image({2, 2, {Rgb(1.f), Rgb(2.f), Rgb(3.f), Rgb(5.f)}});
    EXPECT_EQ(image.lookup(Vec2(0.25f, 0.25f)), Rgb(1.f));
    EXPECT_EQ(image.lookup(Vec2(0.75f, 0.25f)), Rgb(2.f));
    EXPECT_EQ(image.lookup(Vec2(0.25f, 0.75f)), Rgb(3.f));
    EXPECT_EQ(image.lookup(Vec2(0.5f, 0.5f)), Rgb(2.75f));
    EXPECT_EQ(image.mean(), Rgb(2.75f));
    // Beyond its edges, pixels are extended.
    EXPECT_EQ(image.lookup(Vec2(-3, 0.1f)), Rgb(1.f));
    EXPECT_EQ(image.lookup(Vec2(7, 8)), Rgb(5.f));
}

TEST(EmissionImage, MayRepeat) {
    const EmissionImage image({2, 2, {Rgb(1.f), Rgb(2.f), Rgb(3.f), Rgb(5.f)}, true});
    EXPECT_EQ(image.lookup(Vec2(-2.75f, 5.25f)), Rgb(1.f));
    EXPECT_EQ(image.lookup(Vec2(0, 0)), Rgb(2.75f));
    EXPECT_EQ(image.lookup(Vec2(1, 0.25f)), Rgb(1.5f));
}

TEST(EmissionImage, CoordinatesMayBeAnything) {
    for (const bool repeats : {false, true}) {
        const EmissionImage image(noise(5, 3, repeats));
        for (const float x : {NAN, kInfinity, -kInfinity, 1e30f, -1e30f, 3e9f, 0x1.fffffep-1f, -1e-12f})
            for (const float y : {NAN, 1e38f, 0.5f}) {
                EXPECT_TRUE(isFinite(image.lookup(Vec2(x, y))));
                EXPECT_TRUE(std::isfinite(image.meanLuminance(Vec2(x, y), Vec2(x, y))));
                EXPECT_TRUE(std::isfinite(image.meanLuminance(Vec2(-1e30f, 0), Vec2(x, y))));
            }
    }
}

TEST(EmissionImage, BrokenPixelsAreBlack) {
    const EmissionImage image({2, 1, {Rgb(NAN, 1, 1), Rgb(1, -1, kInfinity)}});
    EXPECT_EQ(image.mean(), Rgb(0.f));
    EXPECT_EQ(EmissionImage({1, 1, {Rgb(1, -1, 2)}}).lookup(Vec2(0.5f, 0.5f)), Rgb(1, 0, 2));
}

// The mean is zero only where all lookups are black, and near the mean of lookups where these are many pixels apart.
TEST(EmissionImage, MeansOfRegionsHoldAllThatLookupsFind) {
    for (const bool repeats : {false, true}) {
        const EmissionImage image(noise(37, 23, repeats));
        Pcg32 rng(5);
        int black = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec2 low(3 * rng.nextFloat() - 1, 3 * rng.nextFloat() - 1);
            const Vec2 high = low + Vec2(rng.nextFloat(), rng.nextFloat()) * (i % 2 ? 0.06f : 1.f);
            const double mean = image.meanLuminance(low, high);
            float brightest = 0;
            double sum = 0;
            constexpr int kLookups = 16;
            for (int k = 0; k < kLookups * kLookups; ++k) {
                const Vec2 t((float(k % kLookups) + 0.5f) / kLookups, (float(k / kLookups) + 0.5f) / kLookups);
                const float l = luminance(image.lookup(Vec2(lerp(t.x, low.x, high.x), lerp(t.y, low.y, high.y))));
                brightest = std::max(brightest, l);
                sum += double(l) / (kLookups * kLookups);
            }
            if (mean == 0) {
                EXPECT_EQ(brightest, 0);
                ++black;
            }
            if (repeats && high.x - low.x > 0.7f && high.y - low.y > 0.7f) {
                EXPECT_NEAR(mean, sum, 0.02);  // of a mean of .05
            }
        }
        EXPECT_GT(black, 5);
    }
    // With the whole range, it is the mean of all pixels.
    const EmissionImage image(noise(8, 4, false));
    EXPECT_NEAR(image.meanLuminance(Vec2(0, 0), Vec2(1, 1)), double(luminance(image.mean())), 1e-6);
}

TEST(Emission, IsOneRadianceOrAScaledImage) {
    const Emission plain = Rgb(1, 2, 3);
    EXPECT_EQ(plain.image(), nullptr);
    EXPECT_EQ(plain.at(Vec2(0.3f, 0.2f)), Rgb(1, 2, 3));
    const Emission shown(std::make_shared<EmissionImage>(LightImage{1, 1, {Rgb(2.f)}}), Rgb(1, 2, 3));
    EXPECT_EQ(shown.at(Vec2(0.3f, 0.2f)), Rgb(2, 4, 6));
}

}  // namespace
}  // namespace drc
