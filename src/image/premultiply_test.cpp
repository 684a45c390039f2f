#include "image/premultiply.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Premultiply, DividesByAlphaAndAppendsIt) {
    Image colours(2, 1), alpha(2, 1, {"A"});
    colours.setRgb(0, 0, Rgb(0.25f, 0.5f, 1));
    colours.setRgb(1, 0, Rgb(3, 0, 0));  // a glow before nothing
    alpha.at(0, 0, 0) = 0.5f;
    const Image straight = unpremultiplied(colours, alpha);
    EXPECT_EQ(straight.rgb(0, 0), Rgb(0.5f, 1, 2));
    EXPECT_EQ(straight.rgb(1, 0), Rgb(0.f));
    const Image both = withAlpha(colours, alpha);
    EXPECT_EQ(both.channelNames(), (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(both.rgb(0, 0), colours.rgb(0, 0));
    EXPECT_EQ(both.at(0, 0, 3), 0.5f);
    EXPECT_EQ(both.at(1, 0, 3), 0);
}

}  // namespace
}  // namespace drc
