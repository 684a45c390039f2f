#include "scene/shapes/parallelogram.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

const Vec3 kA(1, 2, 3), kB(4, 2, 3.5f), kC(4.5f, 6, 3), kD(1.5f, 6, 2.5f);  // corners in order around a parallelogram

TEST(Parallelogram, IsFoundWhicheverCornersTheTrianglesBeginWith) {
    std::array<Vec3, 3> first{kA, kB, kC};
    for (int i = 0; i < 3; ++i) {
        std::array<Vec3, 3> second{kA, kC, kD};
        for (int j = 0; j < 3; ++j) {
            const auto whole = parallelogramOf(first, second);
            ASSERT_TRUE(whole);
            // B is the corner that only the first triangle has.
            EXPECT_EQ(whole->corner, kB);
            EXPECT_EQ(whole->side0, kC - kB);
            EXPECT_EQ(whole->side1, kA - kB);
            std::rotate(second.begin(), second.begin() + 1, second.end());
        }
        std::rotate(first.begin(), first.begin() + 1, first.end());
    }
}

TEST(Parallelogram, MayBeOffByRounding) {
    const std::array<Vec3, 3> first{kA, kB, kC};
    EXPECT_TRUE(parallelogramOf(first, {kA, kC, kD + Vec3(2e-6f, -2e-6f, 0)}));
    EXPECT_FALSE(parallelogramOf(first, {kA, kC, kD + Vec3(2e-5f, 0, 0)}));
    EXPECT_FALSE(parallelogramOf(first, {kA, kC, kD + Vec3(0, 0, 2e-5f)}));
}

TEST(Parallelogram, IsNoneOfOtherPairs) {
    const std::array<Vec3, 3> first{kA, kB, kC};
    EXPECT_FALSE(parallelogramOf(first, {kA, kD, kC}));             // opposite winding
    EXPECT_FALSE(parallelogramOf(first, {kA, kC, Vec3(0, 6, 3)}));  // a trapezoid
    EXPECT_FALSE(parallelogramOf(first, {kA, kC, kB}));             // the same triangle, seen from behind
    EXPECT_FALSE(parallelogramOf(first, first));
    const Vec3 far(20, 0, 0);
    EXPECT_FALSE(parallelogramOf(first, {kA + far, kC + far, kD + far}));
}

}  // namespace
}  // namespace drc
