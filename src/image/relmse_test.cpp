#include "image/relmse.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drc {
namespace {

Image constant(int width, int height, float value) {
    Image image(width, height);
    for (float& v : image.data()) v = value;
    return image;
}

TEST(RadianceErrors, ByHand) {
    const RadianceErrors e = radianceErrors(constant(4, 4, 0.5f), constant(4, 4, 0.75f));
    EXPECT_NEAR(e.mse, 0.0625, 1e-12);
    EXPECT_NEAR(e.l1, 0.25, 1e-12);
    EXPECT_NEAR(e.relmse, 0.0625 / 0.26, 1e-12);
    for (const double ratio : e.meanRatio) EXPECT_NEAR(ratio, 1.5, 1e-12);
}

TEST(RadianceErrors, RelMseDropsTheWorstThousandth) {
    const Image reference = constant(50, 40, 1);  // 2000 pixels: two are dropped
    Image test = reference;
    test.setRgb(3, 4, Rgb(1e6f, 1, 1));
    test.setRgb(30, 4, Rgb(1, 1e3f, 1));
    EXPECT_EQ(radianceErrors(reference, test).relmse, 0);
    EXPECT_GT(radianceErrors(reference, test).mse, 1e6);
    test.setRgb(7, 7, Rgb(2, 1, 1));  // now the third worst counts, among 1998
    EXPECT_NEAR(radianceErrors(reference, test).relmse, 1 / 1.01 / 3 / 1998, 1e-12);
}

TEST(RadianceErrors, CountsNonFinitePixels) {
    Image reference = constant(10, 10, 1), test = constant(10, 10, 2);
    test.at(1, 1, 0) = test.at(1, 1, 2) = std::numeric_limits<float>::quiet_NaN();
    test.at(2, 2, 1) = kInfinity;
    reference.at(3, 3, 1) = kInfinity;
    const RadianceErrors e = radianceErrors(reference, test);
    EXPECT_EQ(e.nonFiniteTest, 2);
    EXPECT_EQ(e.nonFiniteReference, 1);
    EXPECT_NEAR(e.l1, 1, 1e-12);
    EXPECT_TRUE(std::isnan(radianceErrors(reference, constant(10, 10, NAN)).relmse));
}

TEST(RadianceErrors, BlackChannels) {
    Image reference(2, 2), test(2, 2);
    test.at(0, 0, 2) = 1;
    const RadianceErrors e = radianceErrors(reference, test);
    EXPECT_EQ(e.meanRatio[0], 1);
    EXPECT_TRUE(std::isinf(e.meanRatio[2]));
}

}  // namespace
}  // namespace drc
