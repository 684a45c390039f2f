#include "image/entropy.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/color.h"

namespace drc {
namespace {

TEST(Entropy, OneLevelHasNone) {
    Image image(7, 5);
    EXPECT_EQ(luminanceEntropy(image), 0);
    for (float& x : image.data()) x = 3;  // clipped, like 2
    image.setRgb(1, 1, Rgb(2, 2, 2));
    EXPECT_EQ(luminanceEntropy(image), 0);
}

TEST(Entropy, LevelsThatAreAsFrequentAddUp) {
    Image image(256, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 256; ++x) {
            const float grey = srgbDecode(float(x) / 255);
            image.setRgb(x, y, Rgb(grey, grey, grey));
        }
    EXPECT_NEAR(luminanceEntropy(image), 8, 1e-12);
}

TEST(Entropy, ThreeToOne) {
    Image image(4, 1);
    image.setRgb(2, 0, Rgb(0, 1, 0));
    EXPECT_NEAR(luminanceEntropy(image), 0.8112781, 1e-7);  // 2 - 3/4 log2(3)
}

TEST(Entropy, GreyPicturesAreTheirFirstChannel) {
    Image image(2, 1, {"Y"});
    image.at(1, 0, 0) = 1;
    EXPECT_EQ(luminanceEntropy(image), 1);
}

TEST(Entropy, NoPixelsAreAnError) { EXPECT_THROW(luminanceEntropy(Image()), Error); }

}  // namespace
}  // namespace drc
