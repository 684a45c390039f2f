#include "math/morton.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

TEST(Morton, EnumeratesASquareOfEachPowerOfTwo) {
    for (const int n : {2, 8, 64}) {
        for (uint32_t i = 0; i < uint32_t(n * n); ++i) {
            const GridCell c = mortonCell(i);
            EXPECT_LT(c.column, n);
            EXPECT_LT(c.row, n);
            EXPECT_EQ(mortonIndex(c), i);
        }
    }
    EXPECT_EQ(mortonIndex({3, 5}), 0b100111u);
    EXPECT_EQ(mortonIndex({0xffff, 0xffff}), 0xffffffffu);
}

}  // namespace
}  // namespace drc
