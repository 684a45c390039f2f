#include "image/relative_norm.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"
#include "image/noise_testing.h"

namespace drc {
namespace {

using noise_testing::Rng;

Image flat(float value, int width = 24, int height = 20) {
    Image image(width, height);
    for (float& v : image.data()) v = value;
    return image;
}

TEST(RelativeNorm, OfAFlatPictureIsItsRadiance) {
    const Image norm = relativeNorm(flat(0.7f), flat(0.5f));
    for (const float d : norm.data()) EXPECT_NEAR(d, 0.6f, 1e-6f);
    const Image ofNegative = relativeNorm(flat(-1), flat(-1));
    for (const float d : ofNegative.data()) EXPECT_EQ(d, 0);
}

// That is what makes the mean of the quotients unbiased.
TEST(RelativeNorm, DoesNotKnowThePixelAndItsNeighbours) {
    const Image scene = noise_testing::scene(40, 32);
    const Image norm = relativeNorm(scene, scene);
    for (const auto& [px, py] : {std::pair(20, 16), {0, 0}, {39, 5}, {17, 31}}) {
        Image first = scene, second = scene;
        for (int y = std::max(0, py - 1); y <= std::min(31, py + 1); ++y)
            for (int x = std::max(0, px - 1); x <= std::min(39, px + 1); ++x) {
                first.setRgb(x, y, scene.rgb(x, y) * 1.3f);
                second.setRgb(x, y, scene.rgb(x, y) * 0.8f);
            }
        const Image changed = relativeNorm(first, second);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(changed.at(px, py, c), norm.at(px, py, c)) << px << " " << py;
        EXPECT_NE(changed.at(px, py == 31 ? 28 : py + 3, 0), norm.at(px, py == 31 ? 28 : py + 3, 0));
    }
}

TEST(RelativeNorm, AFireflyOfOneReferenceHardlyCounts) {
    Image first = flat(1);
    first.setRgb(10, 10, Rgb(1e4f));
    const Image norm = relativeNorm(first, flat(1));
    for (const float d : norm.data()) EXPECT_NEAR(d, 1, 0.07f);
    EXPECT_GT(norm.at(10, 12, 0), 1.01f);
}

TEST(RelativeNorm, AHighlightOfBothCountsAsWhatItIs) {
    Image highlight = flat(1);
    highlight.setRgb(10, 10, Rgb(50));
    Image other = highlight;
    other.setRgb(10, 10, Rgb(60));
    EXPECT_EQ(relativeNorm(highlight, other).at(10, 10, 1), 25);
    EXPECT_EQ(relativeNorm(highlight, flat(1)).at(10, 10, 1), 1);
}

TEST(RelativeNorm, LeavesOutWhatIsNotFinite) {
    Image first = flat(1);
    first.at(10, 10, 0) = std::numeric_limits<float>::quiet_NaN();
    first.at(12, 10, 1) = std::numeric_limits<float>::infinity();
    const Image ofSome = relativeNorm(first, flat(1)), ofNothing = relativeNorm(flat(NAN), flat(1));
    for (const float d : ofSome.data()) EXPECT_NEAR(d, 1, 1e-6f);
    for (const float d : ofNothing.data()) EXPECT_EQ(d, 0);
    EXPECT_EQ(relativeNorm(flat(3, 1, 1), flat(3, 1, 1)).at(0, 0, 0), 1.5f);
    EXPECT_THROW(relativeNorm(flat(1), flat(1, 3, 3)), Error);
}

}  // namespace
}  // namespace drc
