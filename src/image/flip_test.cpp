#include "image/flip.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/test_images.h"

namespace drc {
namespace {

TEST(Flip, IsZeroForTheSameImage) {
    EXPECT_EQ(flip(testing_images::changed(), testing_images::changed()), 0);
    EXPECT_EQ(flip(Image(1, 1), Image(1, 1)), 0);
}

// The authors' own evaluator (flip-evaluator 1.7 on PyPI), fed with the sRGB-encoded images: evaluate(reference, test,
// "LDR", applyMagma=False, parameters={"ppd": 67}), and 30.
TEST(Flip, AgreesWithTheAuthorsEvaluator) {
    const Image r = testing_images::reference(), t = testing_images::changed();
    EXPECT_NEAR(flip(r, t), 0.374297, 2e-4);
    EXPECT_NEAR(flip(r, t, 30), 0.369182, 2e-4);
    const Plane map = flipMap(r, t);
    EXPECT_NEAR(map.at(0, 0), 0.417921, 5e-4);
    EXPECT_NEAR(map.at(22, 12), 0.616398, 5e-4);
    EXPECT_NEAR(map.at(47, 39), 0.363634, 5e-4);
}

TEST(Flip, StaysWithinZeroAndOne) {
    Image black(32, 32), white(32, 32);
    for (float& v : white.data()) v = 1;
    for (int y = 0; y < 32; ++y) white.setRgb(16, y, Rgb(0, 0, 50));
    for (const float v : flipMap(black, white).values) {
        EXPECT_GE(v, 0.3f);
        EXPECT_LE(v, 1.f);
    }
}

TEST(Flip, RefusesDifferentSizes) { EXPECT_THROW(flip(Image(2, 3), Image(3, 2)), Error); }

}  // namespace
}  // namespace drc
