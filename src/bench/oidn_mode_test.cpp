#include "bench/oidn_mode.h"

#include <gtest/gtest.h>

#include <string>

namespace drc {
namespace {

std::string best(double seconds, double pixels, int threads) { return bestOidnMode(seconds, pixels, threads).name; }

TEST(OidnMode, TheBudgetPaysForIt) {
    constexpr double kUsers = 1280. * 720;
    EXPECT_EQ(best(10, kUsers, 2), "balanced-raw");
    EXPECT_EQ(best(30, kUsers, 2), "balanced-raw");  // high would take 14 s
    EXPECT_EQ(best(60, kUsers, 2), "high");
    EXPECT_EQ(best(30, kUsers, 16), "high");
    EXPECT_EQ(best(7.5, kUsers / 4, 2), "balanced-raw");  // the same samples a pixel
    EXPECT_EQ(best(0.1, kUsers, 2), "fast-raw");
    EXPECT_EQ(best(1, 64 * 48, 2), "high");
}

TEST(OidnMode, ByName) {
    for (const OidnMode& mode : oidnModes()) EXPECT_EQ(findOidnMode(mode.name), &mode);
    EXPECT_EQ(findOidnMode("balanced-raw")->quality, std::string("balanced"));
    EXPECT_FALSE(findOidnMode("balanced-raw")->prefilter);
    EXPECT_TRUE(findOidnMode("balanced")->prefilter);
    EXPECT_EQ(findOidnMode("best"), nullptr);
}

}  // namespace
}  // namespace drc
