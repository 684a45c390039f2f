#include "math/sampler.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace drc {
namespace {

// The first 2^k points of a (0,2)-sequence put exactly one point into every elementary interval of area 2^-k.
template <class Get>
void expectNets(int pairs, Get get) {
    for (const int k : {4, 8, 10}) {
        const int n = 1 << k;
        for (int pair = 0; pair < pairs; ++pair) {
            std::vector<Vec2> points;
            for (int i = 0; i < n; ++i) points.push_back(get(Sampler(1234 + k, uint32_t(i)), pair));
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (const Vec2& p : points) cells.insert({int(p.x * float(1 << a)), int(p.y * float(1 << (k - a)))});
                EXPECT_EQ(int(cells.size()), n) << "interval shape " << a << " of " << k << ", pair " << pair;
            }
        }
    }
}

TEST(Sampler, EveryDimensionPairIsANetInBaseTwo) {
    expectNets(6, [](Sampler s, int pair) {
        for (int d = 0; d < pair; ++d) s.get2D();
        return s.get2D();
    });
}

TEST(Sampler, EachOfFourPairsIsANetInBaseTwo) {
    expectNets(8, [](Sampler s, int pair) {
        if (pair >= 4) s.getFour2D();
        return s.getFour2D()[size_t(pair % 4)];
    });
}

TEST(Sampler, FourPairsAreUncorrelated) {
    constexpr int kCount = 4096, kNumbers = 10;
    double products[kNumbers][kNumbers] = {};
    for (uint32_t i = 0; i < kCount; ++i) {
        Sampler s(3, i);
        const auto four = s.getFour2D();
        const Vec2 next = s.getFour2D()[0];
        float x[kNumbers];
        for (size_t k = 0; k < 4; ++k) {
            x[2 * k] = four[k].x;
            x[2 * k + 1] = four[k].y;
        }
        x[8] = next.x;
        x[9] = next.y;
        for (int a = 0; a < kNumbers; ++a)
            for (int b = 0; b < a; ++b) products[a][b] += (x[a] - 0.5) * (x[b] - 0.5);
    }
    for (int a = 0; a < kNumbers; ++a)
        for (int b = 0; b < a; ++b)
            EXPECT_LT(std::abs(products[a][b] / kCount), 4.0 / (12 * std::sqrt(double(kCount)))) << a << " " << b;
}

TEST(Sampler, OneDimensionIsStratified) {
    std::set<int> cells;
    for (int i = 0; i < 256; ++i) cells.insert(int(Sampler(7, uint32_t(i)).get1D() * 256));
    EXPECT_EQ(cells.size(), 256u);
}

TEST(Sampler, StreamsAndDimensionsAreUncorrelated) {
    const int n = 4096;
    double acrossStreams = 0, acrossDimensions = 0;
    for (int i = 0; i < n; ++i) {
        Sampler a(1, uint32_t(i)), b(2, uint32_t(i));
        const Vec2 p = a.get2D(), q = b.get2D(), r = a.get2D();
        acrossStreams += (p.x - 0.5) * (q.x - 0.5);
        acrossDimensions += (p.x - 0.5) * (r.x - 0.5);
    }
    // For independent samples, the standard deviation of the mean of the product would be 1 / (12 sqrt(n)).
    const double bound = 4.0 / (12 * std::sqrt(double(n)));
    EXPECT_LT(std::abs(acrossStreams / n), bound);
    EXPECT_LT(std::abs(acrossDimensions / n), bound);
}

TEST(Sampler, SameArgumentsSameNumbers) {
    Sampler a(42, 7), b(42, 7);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(a.get2D(), b.get2D());
    EXPECT_NE(a.split(0).get1D(), a.split(0).get1D()) << "two splits must differ";
}

}  // namespace
}  // namespace drc
