#include "image/resize.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "base/parallel.h"

namespace drc {
namespace {

using testing::HasSubstr;

double meanOf(const Image& image, int channel) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) sum += double(image.at(x, y, channel));
    return sum / double(image.pixelCount());
}

TEST(Resize, ConstantsAndRampsStay) {
    Image image(30, 20, {"R", "G", "d.Z"});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x) {
            image.at(x, y, 0) = 0.7f;
            image.at(x, y, 1) = (float(x) + 0.5f) / 30;
            image.at(x, y, 2) = (float(y) + 0.5f) / 20;
        }
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{60, 40}, {15, 10}, {7, 33}, {30, 20}, {1, 1}}) {
        const Image result = resized(image, width, height);
        EXPECT_EQ(result.channelNames(), image.channelNames());
        for (const float v : {result.at(0, 0, 0), result.at(width - 1, height / 2, 0)}) EXPECT_NEAR(v, 0.7, 1e-6);
        // Away from the edges, where the filter is cut off.
        const int x = width / 2, y = height / 2;
        EXPECT_NEAR(result.at(x, y, 1), (float(x) + 0.5f) / float(width), 2e-3) << width;
        EXPECT_NEAR(result.at(x, y, 2), (float(y) + 0.5f) / float(height), 2e-3) << height;
    }
}

// Noise of pixels as small as a checkerboard's does not alias, and light is preserved.
TEST(Resize, SmallDetailIsAveragedInLinearLight) {
    Image image(64, 64, {"Y"});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) image.at(x, y, 0) = float((x + y) % 2);
    const Image half = resized(image, 23, 23);
    for (int y = 3; y < 20; ++y)
        for (int x = 3; x < 20; ++x) EXPECT_NEAR(half.at(x, y, 0), 0.5, 0.02);
    Image lamp(64, 48, {"Y"});
    lamp.at(31, 22, 0) = 1000;
    EXPECT_NEAR(meanOf(resized(lamp, 16, 12), 0) / meanOf(lamp, 0), 1, 0.15);
}

// A window in a dark wall: what stands beside it stays as it is.
TEST(Resize, BrightThingsHaveNoDarkRims) {
    Image image(32, 32, {"Y"});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) image.at(x, y, 0) = x > 10 && x < 20 && y > 10 && y < 20 ? 1e4f : 0.1f;
    for (const int size : {16, 21, 32, 70}) {
        const Image result = resized(image, size, size);
        for (const float v : result.data()) {
            EXPECT_GE(v, 0.1f * 0.9999f) << size;
            EXPECT_LE(v, 1e4f * 1.0001f) << size;
        }
    }
    EXPECT_EQ(resized(image, 32, 32).data(), image.data());
}

TEST(Resize, ThreadsChangeNothing) {
    Image image(31, 17);
    for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = float(i * i % 101);
    setThreadCount(1);
    const Image one = resized(image, 50, 9);
    setThreadCount(3);
    EXPECT_EQ(resized(image, 50, 9).data(), one.data());
    setThreadCount(0);
}

TEST(Resize, SizesThatAreNoneAreRefused) {
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{0, 5}, {5, -1}, {100000, 2}, {2, 100000}, {65536, 65536}})
        EXPECT_THAT(errorOf([&] { resized(Image(2, 2), width, height); }), HasSubstr("cannot be resized to")) << width;
}

}  // namespace
}  // namespace drc
