#include "image/image.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace drc {
namespace {

TEST(Image, PixelsAndChannels) {
    Image image(3, 2, {"R", "G", "B", "A"});
    EXPECT_EQ(image.data().size(), 24u);
    EXPECT_EQ(image.at(2, 1, 3), 0);
    image.at(2, 1, 3) = 5;
    image.setRgb(2, 1, Rgb(1, 2, 3));
    EXPECT_EQ(image.data()[23], 5);
    EXPECT_EQ(image.rgb(2, 1), Rgb(1, 2, 3));
    EXPECT_EQ(image.channelIndex("A"), 3);
    EXPECT_EQ(image.channelIndex("Z"), -1);
    EXPECT_EQ(image.toRgb().channels(), 3);
    EXPECT_EQ(image.toRgb().rgb(2, 1), Rgb(1, 2, 3));
}

TEST(Image, GreyGivesGreyRgb) {
    Image image(1, 1, {"Y"});
    image.at(0, 0, 0) = .5f;
    EXPECT_EQ(image.rgb(0, 0), Rgb(.5f, .5f, .5f));
}

TEST(Image, Crop) {
    Image image(4, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) image.setRgb(x, y, Rgb(float(x), float(y), 7));
    const Image part = image.crop(1, 1, 4, 3);
    EXPECT_EQ(sizeString(part), "3x2");
    EXPECT_EQ(part.rgb(0, 0), Rgb(1, 1, 7));
    EXPECT_EQ(part.rgb(2, 1), Rgb(3, 2, 7));
    EXPECT_THROW(image.crop(0, 0, 5, 1), Error);
    EXPECT_THROW(image.crop(2, 0, 2, 1), Error);
}

TEST(Image, RefusesNonsense) {
    EXPECT_THROW(Image(0, 5), Error);
    EXPECT_THROW(Image(5, -1), Error);
    EXPECT_THROW(Image(1, 1, {}), Error);
    EXPECT_THROW(Image(1, 1, {"R", "R"}), Error);
}

}  // namespace
}  // namespace drc
