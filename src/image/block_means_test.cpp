#include "image/block_means.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"

namespace drc {
namespace {

// Red is x, green is y, blue is their product.
Image ramps(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.setRgb(x, y, Rgb(float(x), float(y), float(x * y)));
    return image;
}

TEST(BlockMeans, OfWholeBlocks) {
    const Image means = blockMeans(ramps(8, 12), 4);
    ASSERT_EQ(means.width(), 2);
    ASSERT_EQ(means.height(), 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 2; ++x) {
            EXPECT_FLOAT_EQ(means.at(x, y, 0), 1.5f + 4 * float(x));
            EXPECT_FLOAT_EQ(means.at(x, y, 1), 1.5f + 4 * float(y));
            EXPECT_FLOAT_EQ(means.at(x, y, 2), (1.5f + 4 * float(x)) * (1.5f + 4 * float(y)));
        }
}

TEST(BlockMeans, BlocksAtTheEdgeAreSmaller) {
    const Image means = blockMeans(ramps(10, 5), 4);
    ASSERT_EQ(means.width(), 3);
    ASSERT_EQ(means.height(), 2);
    EXPECT_FLOAT_EQ(means.at(2, 0, 0), 8.5f);
    EXPECT_FLOAT_EQ(means.at(2, 1, 1), 4);
}

TEST(BlockMeans, LeaveOutWhatIsNotFinite) {
    Image image = ramps(4, 2);
    image.at(0, 0, 2) = std::numeric_limits<float>::quiet_NaN();
    image.at(1, 1, 0) = std::numeric_limits<float>::infinity();
    const Image means = blockMeans(image, 2);
    EXPECT_FLOAT_EQ(means.at(0, 0, 0), 0.5f);  // of (1, 0) and (0, 1)
    EXPECT_FLOAT_EQ(means.at(1, 0, 0), 2.5f);
    for (float& v : image.data()) v = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(blockMeans(image, 2).at(0, 0, 1)));
    EXPECT_THROW(blockMeans(image, 0), Error);
}

}  // namespace
}  // namespace drc
