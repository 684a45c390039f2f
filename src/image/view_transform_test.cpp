#include "image/view_transform.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "image/test_images.h"

namespace drc {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float greyOf(float radiance, View view) { return viewed(Rgb(radiance), view).y; }

TEST(ViewTransform, MiddleGreyStaysAndGreysStayGrey) {
    for (const View view : allViews()) {
        EXPECT_NEAR(greyOf(0.18f, view), 0.18, 1e-5) << viewName(view);
        for (float v = 1e-5f; v < 1e3f; v *= 1.7f) {
            const Rgb c = viewed(Rgb(v), view);
            EXPECT_NEAR(c.x, c.y, 2e-6) << viewName(view) << v;
            EXPECT_NEAR(c.z, c.y, 2e-6) << viewName(view) << v;
        }
    }
}

TEST(ViewTransform, BrighterIsNeverDarkerAndNothingLeavesTheDisplay) {
    for (const View view : allViews()) {
        float last = 0;
        for (float v = 1e-6f; v < 1e4f; v *= 1.01f) {
            const float shown = greyOf(v, view);
            EXPECT_GE(shown, last - 1e-6f) << viewName(view) << " " << v;
            last = shown;
        }
        EXPECT_NEAR(last, 1, 1e-5) << viewName(view);
        for (const Rgb& c : {Rgb(1e5f, 0, 0), Rgb(0, 30, 1e-3f), Rgb(5, 0, 9)})
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(viewed(c, view)[i], 0);
                EXPECT_LE(viewed(c, view)[i], 1);
            }
    }
}

TEST(ViewTransform, WhatIsNoColourIsBlackOrWhite) {
    for (const View view : allViews()) {
        EXPECT_EQ(viewed(Rgb(0.f), view), Rgb(0.f)) << viewName(view);
        EXPECT_EQ(viewed(Rgb(-3.f), view), Rgb(0.f)) << viewName(view);
        EXPECT_EQ(viewed(Rgb(kNan), view), Rgb(0.f)) << viewName(view);
        EXPECT_NEAR(viewed(Rgb(kInfinity), view).y, 1, 1e-5) << viewName(view);
    }
}

TEST(ViewTransform, SrgbShowsTheRangeOfTheDisplayAsItIs) {
    EXPECT_EQ(viewed(Rgb(0.25f, 1, 1.5f), View::Srgb), Rgb(0.25f, 1, 1));
}

// The curve as published, of radiance times a scale, which is found where the curve has the value that it has at 1.
TEST(ViewTransform, FilmicIsThePublishedCurve) {
    const auto published = [](float x) { return (x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f); };
    float low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
        const float middle = (low + high) / 2;
        (greyOf(middle, View::Filmic) < published(1) ? low : high) = middle;
    }
    for (const float x : {0.01f, 0.1f, 0.5f, 2.f, 5.f})
        EXPECT_NEAR(greyOf(low * x, View::Filmic), published(x), 1e-5) << x;
    EXPECT_EQ(greyOf(0.18f * std::exp2(5.85f), View::Filmic), 1);
    EXPECT_LT(greyOf(0.18f * std::exp2(5.75f), View::Filmic), 1);
}

// Slope of the code value at middle grey: 2.4 of the whole range of 16.5 stops.
TEST(ViewTransform, AgxHasItsRangeAndSlope) {
    const auto code = [](float stops) { return std::pow(greyOf(0.18f * std::exp2(stops), View::Agx), 1 / 2.4f); };
    EXPECT_NEAR((code(0.03f) - code(-0.03f)) / 0.06f, 2.4f / 16.5f, 2e-4);
    EXPECT_EQ(code(-10.5f), 0);
    EXPECT_NEAR(code(6.5f), 1, 1e-5);
    EXPECT_LT(code(6), 0.9995);
    EXPECT_GT(code(-9), 1e-3);
}

// Calculated from Sobotka's matrix and the sigmoid, independently of this code, in double precision.
TEST(ViewTransform, AgxOfColours) {
    const struct {
        Rgb radiance, shown;
    } cases[] = {
        {Rgb(1, 1, 1), Rgb(0.555999f, 0.555999f, 0.555999f)},
        {Rgb(0.8f, 0.2f, 0.05f), Rgb(0.569138f, 0.218030f, 0.068094f)},
        {Rgb(4, 0.5f, 0.1f), Rgb(0.898492f, 0.452233f, 0.250325f)},
        {Rgb(0.02f, 0.03f, 0.3f), Rgb(0.024637f, 0.032800f, 0.313335f)},
        {Rgb(0.5f, 20, 0.5f), Rgb(0.672369f, 1.000000f, 0.672369f)},
    };
    for (const auto& c : cases)
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(viewed(c.radiance, View::Agx)[i], c.shown[i], 2e-5) << c.radiance;
}

// What the view is for: a lamp of one colour becomes white where it is bright, while clipping leaves pure blue.
TEST(ViewTransform, AgxPalesWhatIsBright) {
    const auto saturation = [](const Rgb& c) { return 1 - std::min({c.x, c.y, c.z}) / maxComponent(c); };
    const Rgb blue(0.01f, 0.02f, 1);
    EXPECT_GT(saturation(viewed(blue * 10, View::Srgb)), 0.89);
    float last = 1;
    for (float v = 0.18f; v < 20; v *= 2) {
        const float now = saturation(viewed(blue * v, View::Agx));
        EXPECT_LT(now, last);
        last = now;
    }
    EXPECT_LT(last, 0.6);
    EXPECT_LT(saturation(viewed(blue * 300, View::Agx)), 0.05);
}

TEST(ViewTransform, OfAPictureIsOfItsPixelsByAnyThreads) {
    const Image image = testing_images::reference();
    setThreadCount(1);
    const Image one = viewed(image, View::Agx, 1.5f);
    setThreadCount(3);
    const Image three = viewed(image, View::Agx, 1.5f);
    setThreadCount(0);
    EXPECT_EQ(one.data(), three.data());
    EXPECT_EQ(one.rgb(7, 9), viewed(image.rgb(7, 9) * std::exp2(1.5f), View::Agx));
    Image grey(2, 1, {"Y"});
    grey.data() = {0.1f, 0.25f};
    EXPECT_EQ(viewed(grey, View::Srgb, 1).rgb(1, 0), Rgb(0.5f));
}

}  // namespace
}  // namespace drc
