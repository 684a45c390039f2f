#include "image/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/parallel.h"
#include "image/test_images.h"

namespace drc {
namespace {

TEST(Metrics, OfEqualImages) {
    const Image image = testing_images::reference();
    const Metrics m = compare(image, image);
    EXPECT_NEAR(m.ssim, 1, 1e-6);
    EXPECT_EQ(m.flip, 0);
    EXPECT_EQ(m.relmse, 0);
    EXPECT_EQ(m.mse, 0);
    EXPECT_EQ(m.l1, 0);
    EXPECT_THAT(m.meanRatio, testing::Each(1));
    EXPECT_EQ(m.pngKb[0], m.pngKb[1]);
    EXPECT_GT(m.pngKb[0], 0.1);
    EXPECT_EQ(m.nonFiniteTest, 0);
}

TEST(Metrics, ExposureChangesOnlyWhatIsDisplayed) {
    const Image r = testing_images::reference(), t = testing_images::changed();
    const Metrics a = compare(r, t), b = compare(r, t, -2);
    EXPECT_EQ(a.relmse, b.relmse);
    EXPECT_EQ(a.meanRatio, b.meanRatio);
    EXPECT_GT(a.flip, b.flip);
    EXPECT_NE(a.ssim, b.ssim);
}

// Noise goes, a patch that is too bright stays: 2x2 pixels of 8 and 2 against 5, and one block of 16 that is 6.
TEST(Metrics, BlocksTellErrorsFromNoise) {
    Image r(32, 32), t(32, 32);
    for (float& v : r.data()) v = 5;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) t.setRgb(x, y, Rgb((x + y) % 2 ? 8.f : 2.f));
    EXPECT_NEAR(compare(r, t).blockRelmse, 0, 1e-9);
    EXPECT_GT(compare(r, t).relmse, 0.3);
    for (int y = 8; y < 16; ++y)
        for (int x = 24; x < 32; ++x) t.setRgb(x, y, Rgb(6.f));
    EXPECT_NEAR(compare(r, t).blockRelmse, 1 / 25.01 / 16, 1e-9);
}

TEST(Metrics, DoNotDependOnTheThreadCount) {
    const Image r = testing_images::reference(), t = testing_images::changed();
    setThreadCount(1);
    const Metrics a = compare(r, t);
    setThreadCount(4);
    const Metrics b = compare(r, t);
    setThreadCount(0);
    EXPECT_EQ(a.flip, b.flip);
    EXPECT_EQ(a.ssim, b.ssim);
}

TEST(Metrics, NanDoesNotSpoilWhatIsDisplayed) {
    Image t = testing_images::changed();
    t.at(5, 5, 0) = std::numeric_limits<float>::quiet_NaN();
    const Metrics m = compare(testing_images::reference(), t);
    EXPECT_EQ(m.nonFiniteTest, 1);
    EXPECT_TRUE(std::isfinite(m.ssim) && std::isfinite(m.flip) && std::isfinite(m.relmse));
}

TEST(Metrics, RefusesDifferentSizesAndNamesThem) {
    try {
        compare(Image(20, 30), Image(30, 20));
        FAIL();
    } catch (const Error& e) {
        EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("20x30"), testing::HasSubstr("30x20")));
    }
}

}  // namespace
}  // namespace drc
