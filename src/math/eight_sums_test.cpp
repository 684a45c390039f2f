#include "math/eight_sums.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(EightSums, AddsUpInOrder) {
    const float weights[] = {1, 2, 4, 8, 16, 32, 64, 128};
    const EightSums sums(weights);
    float expected = 0;
    for (int i = 0; i < EightSums::kCount; ++i) {
        EXPECT_EQ(sums.before(i), expected);
        expected += weights[i];
    }
    EXPECT_EQ(sums.total(), 255);
}

TEST(EightSums, FindsTheWeightThatHoldsTheTarget) {
    const float weights[] = {1, 0, 2, 0, 0, 3, 1, 0};
    const EightSums sums(weights);
    EXPECT_EQ(sums.find(0), 0);
    EXPECT_EQ(sums.find(0.999f), 0);
    EXPECT_EQ(sums.find(1), 2);  // never one without weight
    EXPECT_EQ(sums.find(2.999f), 2);
    EXPECT_EQ(sums.find(3), 5);
    EXPECT_EQ(sums.find(6.5f), 6);
    EXPECT_EQ(sums.find(7), EightSums::kCount);
    EXPECT_EQ(sums.last(), 6);
}

TEST(EightSums, FirstWeightsMayBeZero) {
    const float weights[] = {0, 0, 5, 0, 0, 0, 0, 0};
    const EightSums sums(weights);
    EXPECT_EQ(sums.find(0), 2);
    EXPECT_EQ(sums.last(), 2);
}

TEST(EightSums, GoOnFromAnOffset) {
    const float weights[] = {1, 1, 1, 1, 1, 1, 1, 1};
    const EightSums sums(weights, 10);
    EXPECT_EQ(sums.before(0), 10);
    EXPECT_EQ(sums.find(10.5f), 0);
    EXPECT_EQ(sums.find(14), 4);
    EXPECT_EQ(sums.total(), 18);
}

}  // namespace
}  // namespace drc
