#include "transport/path_state.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(ClampedSample, BoundsLuminanceAndDropsWhatIsNoNumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(clampedSample(Rgb(1, nan, 0), kInfinity), Rgb(0.f));
    EXPECT_EQ(clampedSample(Rgb(1, kInfinity, 0), 2), Rgb(0.f));
    EXPECT_EQ(clampedSample(Rgb(3, 2, 1), kInfinity), Rgb(3, 2, 1));
    const Rgb bounded = clampedSample(Rgb(30, 20, 10), 2);
    EXPECT_NEAR(luminance(bounded), 2, 1e-5);
    EXPECT_NEAR(bounded.x / bounded.z, 3, 1e-5);
}

}  // namespace
}  // namespace drc
