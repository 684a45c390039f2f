#include "image/channel_statistics.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(ChannelStatistics, CountWhatIsNoNumberApart) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Image image(2, 2, {"Y", "Z", "bad"});
    image.data() = {-1, 5, nan, 2, nan, nan, 5, 7, kInfinity, 2, -kInfinity, nan};
    const auto s = channelStatistics(image);
    ASSERT_EQ(s.size(), 3u);
    EXPECT_EQ(s[0].min, -1);
    EXPECT_EQ(s[0].max, 5);
    EXPECT_EQ(s[0].mean, 2);
    EXPECT_EQ(s[0].nan + s[0].infinite, 0);
    EXPECT_EQ(s[1].min, 5);
    EXPECT_EQ(s[1].mean, 6);
    EXPECT_EQ(s[1].nan, 1);
    EXPECT_EQ(s[1].infinite, 1);
    EXPECT_EQ(s[2].nan, 3);
    EXPECT_EQ(s[2].infinite, 1);
    EXPECT_EQ(s[2].max, 0);
}

}  // namespace
}  // namespace drc
