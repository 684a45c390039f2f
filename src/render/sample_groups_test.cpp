#include "render/sample_groups.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

constexpr PixelRegion kRegion{3, 4, 5, 6};

TEST(SampleGroups, MeansGoByFilterWeight) {
    SampleGroups groups(kRegion);
    groups.add(4, 5, 0, Rgb(1, 2, 3), 1);
    groups.add(4, 5, 0, Rgb(5, 2, 3), 3);
    groups.add(4, 5, 2, Rgb(8, 0, 0), 4);
    EXPECT_EQ(groups.group(4, 5, 0), Rgb(4, 2, 3));
    EXPECT_EQ(groups.group(4, 5, 2), Rgb(8, 0, 0));
    EXPECT_EQ(groups.group(4, 5, 1), Rgb(0.f));
    EXPECT_EQ(groups.mean(4, 5), Rgb(6, 1, 1.5f));
    EXPECT_EQ(groups.mean(3, 4), Rgb(0.f));
    EXPECT_EQ(groups.image().rgb(1, 1), Rgb(6, 1, 1.5f));
    groups.add(4, 5, 3, Rgb(0.f), 1, 8);
    EXPECT_EQ(groups.mean(4, 5), Rgb(3, 0.5f, 0.75f));
}

TEST(SampleGroups, VarianceOfTheMeanIsByHowGroupsDiffer) {
    SampleGroups groups(kRegion);
    EXPECT_EQ(groups.varianceOfMean(3, 4), Rgb(0.f));
    groups.add(3, 4, 0, Rgb(1, 5, 0), 1);
    EXPECT_EQ(groups.varianceOfMean(3, 4), Rgb(0.f));
    groups.add(3, 4, 1, Rgb(2, 5, 0), 1);
    groups.add(3, 4, 2, Rgb(3, 5, 0), 1);
    groups.add(3, 4, 3, Rgb(6, 5, 0), 1);
    EXPECT_FLOAT_EQ(groups.varianceOfMean(3, 4).x, 14.f / 12);
    EXPECT_EQ(groups.varianceOfMean(3, 4).y, 0);
    // Of two groups, one with three times the say: weights 1/4 and 3/4 about the mean 3.
    groups.add(4, 5, 0, Rgb(0.f), 1, 2);
    groups.add(4, 5, 1, Rgb(4.f), 1, 6);
    EXPECT_FLOAT_EQ(groups.varianceOfMean(4, 5).x, 2 * (9.f / 16 + 9.f / 16));
}

TEST(SampleGroups, APixelIsCompleteWithASampleInEachGroup) {
    SampleGroups groups(kRegion);
    for (int g = 0; g < SampleGroups::kGroups; ++g) {
        EXPECT_FALSE(groups.complete(3, 4));
        groups.add(3, 4, g, Rgb(0.f), 1);
    }
    EXPECT_TRUE(groups.complete(3, 4));
    EXPECT_FALSE(groups.complete(4, 4));
}

// Weights of a filter with negative lobes may cancel; what they weigh does not.
TEST(SampleGroups, WeightsThatCancelDivideByWhatTheyShouldBe) {
    SampleGroups groups(kRegion);
    groups.add(3, 4, 0, Rgb(1, 1, 1), 1);
    groups.add(3, 4, 0, Rgb(2, 2, 2), -0.9f);
    EXPECT_NEAR(groups.group(3, 4, 0).x, (1 - 0.9f * 2) / 2, 1e-6f);
}

}  // namespace
}  // namespace drc
