#include "base/huge_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <new>

namespace drc {
namespace {

size_t addressSpacePages() {
    size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages;
}

TEST(HugeArray, StartsWithZeroBytes) {
    const HugeArray<uint64_t> array(100'000);
    EXPECT_EQ(array.size(), 100'000u);
    EXPECT_EQ(array.end() - array.begin(), 100'000);
    EXPECT_TRUE(std::ranges::all_of(array, [](uint64_t v) { return v == 0; }));
    EXPECT_EQ(HugeArray<int>().size(), 0u);
}

TEST(HugeArray, AMovedArrayKeepsItsElementsWhereTheyAre) {
    HugeArray<int> a(1000);
    a[999] = 7;
    const int* const at = a.begin();
    HugeArray<int> b(std::move(a));
    EXPECT_EQ(b.begin(), at);
    HugeArray<int> c(10);
    c = std::move(b);
    EXPECT_EQ(c.begin(), at);
    EXPECT_EQ(c.size(), 1000u);
    EXPECT_EQ(c[999], 7);
}

// Of 500 arrays of 64 MiB, of which none is written to, no memory is left, however they end.
TEST(HugeArray, GivesItsMemoryBack) {
    const size_t before = addressSpacePages();
    for (int i = 0; i < 500; ++i) {
        HugeArray<char> array(64 << 20);
        array = HugeArray<char>(64 << 20);
    }
    EXPECT_LT(addressSpacePages(), before + (256 << 20) / 4096);
}

TEST(HugeArray, MoreThanThereIsIsRefused) {
    EXPECT_THROW(HugeArray<char>(std::numeric_limits<size_t>::max() / 4), std::bad_alloc);
}

}  // namespace
}  // namespace drc
