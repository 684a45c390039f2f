#include "math/eight_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/rng.h"
#include "math/vec.h"

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
    EXPECT_EQ(sums.find(1), 2);  // a weight of zero is never chosen
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

// Floating-point addition is not associative, so prefix sums after the last non-zero weight may differ from the total.
// That must not look like another weight.
TEST(EightSums, RoundingNeverFindsAWeightOfZero) {
    Pcg32 rng(5);
    int unequal = 0;
    for (int run = 0; run < 10000; ++run) {
        float weights[EightSums::kCount] = {};
        const unsigned present = 1 + rng.nextUint(255);
        for (int i = 0; i < EightSums::kCount; ++i)
            if (present >> i & 1) weights[i] = rng.nextFloat() + 1e-6f;
        const EightSums sums(weights);
        for (int i = 0; i <= EightSums::kCount; ++i) {
            if (i > 0 && weights[i - 1] == 0 && sums.before(i) != sums.before(i - 1)) ++unequal;
            for (const float step : {-kInfinity, 0.f, kInfinity}) {
                const float target = step == 0 ? sums.before(i) : std::nextafter(sums.before(i), step);
                const int found = sums.find(std::max(0.f, target));
                ASSERT_LE(found, EightSums::kCount);
                ASSERT_TRUE(found == EightSums::kCount || weights[found] > 0) << "run " << run << ", target " << target;
            }
        }
        ASSERT_EQ(sums.last(), int(std::bit_width(present)) - 1);
    }
    EXPECT_GT(unequal, 100) << "rounding was not put to the test";
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
