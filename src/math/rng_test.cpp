#include "math/rng.h"

#include <gtest/gtest.h>

#include <set>

namespace drc {
namespace {

TEST(Pcg32, ReferenceOutput) {
    // The published output of the reference implementation's demonstration: seed 42, sequence 54.
    Pcg32 rng(42, 54);
    for (uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
        EXPECT_EQ(rng.nextUint(), expected);
}

TEST(Pcg32, AdvanceIsRepeatedStepping) {
    Pcg32 a(7, 1), b(7, 1);
    for (int i = 0; i < 1000; ++i) a.nextUint();
    b.advance(1000);
    EXPECT_EQ(a.nextUint(), b.nextUint());
    a.advance(-1001);
    EXPECT_EQ(a.nextUint(), Pcg32(7, 1).nextUint());
}

TEST(Pcg32, FloatsAreUniformBelowOne) {
    EXPECT_EQ(uniformFloat(0xffffffffu), kOneMinusEpsilon);
    EXPECT_EQ(uniformFloat(0), 0.f);
    Pcg32 rng;
    const int n = 1 << 18;
    double sum = 0, sumSquares = 0;
    for (int i = 0; i < n; ++i) {
        const float x = rng.nextFloat();
        sum += x;
        sumSquares += double(x) * x;
    }
    // The tolerance is four standard deviations of the mean.
    EXPECT_NEAR(sum / n, 0.5, 4 * std::sqrt(1 / 12.0 / n));
    EXPECT_NEAR(sumSquares / n, 1 / 3.0, 4 * std::sqrt(4 / 45.0 / n));
}

TEST(Pcg32, BoundedIsUniform) {
    Pcg32 rng(3);
    int counts[7] = {};
    for (int i = 0; i < 70000; ++i) ++counts[rng.nextUint(7)];
    for (int c : counts) EXPECT_NEAR(c, 10000, 4 * std::sqrt(10000 * 6 / 7.0));
}

TEST(Hash, DependsOnEveryArgumentAndTheirOrder) {
    std::set<uint64_t> seen;
    for (int a = 0; a < 40; ++a)
        for (int b = 0; b < 40; ++b)
            for (int c = 0; c < 40; ++c) seen.insert(hash(a, b, c));
    EXPECT_EQ(seen.size(), 64000u);
    EXPECT_NE(hash(1, 2), hash(2, 1));
    EXPECT_NE(hash(0), hash(0, 0));
    EXPECT_EQ(hash(-1), hash(int64_t(-1)));
    EXPECT_EQ(hash(0.f), hash(-0.f));
    EXPECT_EQ(hash32(5, 6u), uint32_t(hash(5, 6) >> 32));
}

TEST(Hash, Avalanche) {
    // Flipping an input bit must flip each output bit half of the time.
    const int n = 4096;
    for (int in = 0; in < 32; ++in) {
        int flips[64] = {};
        for (int i = 0; i < n; ++i) {
            const uint64_t d = hash(uint32_t(i), 5u) ^ hash(uint32_t(i) ^ (1u << in), 5u);
            for (int out = 0; out < 64; ++out) flips[out] += (d >> out) & 1;
        }
        for (int f : flips) EXPECT_NEAR(f, n / 2, 6 * std::sqrt(n / 4.0));
    }
}

}  // namespace
}  // namespace drc
