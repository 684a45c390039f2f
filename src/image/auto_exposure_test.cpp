#include "image/auto_exposure.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

constexpr float kBin = 1 / 32.f;

// A room: luminances about 0.2, evenly in stops, by 2.5 stops to either side.
Image room(float brightness = 1) {
    Image image(40, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) image.setRgb(x, y, Rgb(brightness * 0.2f * std::exp2(float(x) / 39 * 5 - 2.5f)));
    return image;
}

void fill(Image& image, int x0, int y0, int x1, int y1, const Rgb& c) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) image.setRgb(x, y, c);
}

TEST(AutoExposure, TheMeanBecomesMiddleGrey) {
    EXPECT_NEAR(autoExposure(room()), std::log2(0.18f / 0.2f), kBin);
    for (const float brightness : {1e-6f, 0.03f, 700.f, 1e20f})
        EXPECT_NEAR(autoExposure(room(brightness)), std::log2(0.18f / 0.2f) - std::log2(brightness), kBin);
}

TEST(AutoExposure, LampsAndFirefliesDoNotMoveIt) {
    for (const float lamp : {5.f, 1e3f, 1e30f}) {
        Image image = room();
        fill(image, 10, 3, 16, 11, Rgb(lamp));  // 6 % of the picture
        EXPECT_NEAR(autoExposure(image), autoExposure(room()), 0.25) << lamp;
    }
}

TEST(AutoExposure, BlackBordersDoNotMoveItHoweverLarge) {
    for (const float black : {0.f, 1e-9f, 1e-5f, -1.f}) {
        Image framed(80, 80);
        fill(framed, 0, 0, 80, 80, Rgb(black));
        const Image inner = room();
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 40; ++x) framed.setRgb(20 + x, 30 + y, inner.rgb(x, y));
        EXPECT_NEAR(autoExposure(framed), autoExposure(inner), kBin) << black;
    }
}

// A dark room with a large window: its mean alone would burn out a quarter of the picture.
TEST(AutoExposure, AtMostATenthIsClipped) {
    Image image(40, 20);
    fill(image, 0, 0, 40, 20, Rgb(0.01f));
    fill(image, 0, 0, 10, 20, Rgb(1));
    const float stops = autoExposure(image);
    EXPECT_NEAR(stops, 0, kBin);
    Image bright = room(5);
    const float factor = std::exp2(autoExposure(bright));
    int clipped = 0;
    for (int x = 0; x < 40; ++x) clipped += bright.at(x, 0, 1) * factor > 1.02f;
    EXPECT_LE(clipped, 4);
}

// White walls: the mean of log luminance alone would show them as grey.
TEST(AutoExposure, ABrightRoomIsNotGrey) {
    Image image(40, 20);
    fill(image, 0, 0, 40, 20, Rgb(0.8f));
    fill(image, 0, 0, 8, 20, Rgb(0.2f));
    const float forTheMean = std::log2(0.18f / 0.8f) + 0.25f;  // 1/8 of the trimmed pixels are 2 stops darker
    EXPECT_NEAR(autoExposure(image), forTheMean + 1, kBin);
    fill(image, 0, 0, 5, 20, Rgb(2));
    EXPECT_NEAR(autoExposure(image), std::log2(0.7f / 2), kBin);
}

TEST(AutoExposure, PicturesWithoutAnythingInThemStayAsTheyAre) {
    Image image(4, 4);
    EXPECT_EQ(autoExposure(image), 0);
    fill(image, 0, 0, 4, 4, Rgb(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(autoExposure(image), 0);
    fill(image, 0, 0, 4, 2, Rgb(kInfinity));
    EXPECT_EQ(autoExposure(image), 0);
    fill(image, 1, 1, 2, 2, Rgb(0.36f));
    EXPECT_NEAR(autoExposure(image), 0, kBin);
    Image grey(1, 1, {"Y"});
    grey.data() = {0.09f};
    EXPECT_NEAR(autoExposure(grey), 2, kBin);
}

}  // namespace
}  // namespace drc
