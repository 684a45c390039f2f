#include "math/sampler.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace drc {
namespace {

// In a (0,2)-sequence the first 2^k points put exactly one into every elementary interval of area 2^-k.
TEST(Sampler, EveryDimensionPairIsANetInBaseTwo) {
    for (const int k : {4, 8, 10}) {
        const int n = 1 << k;
        for (int dimension = 0; dimension < 6; ++dimension) {
            std::vector<Vec2> points;
            for (int i = 0; i < n; ++i) {
                Sampler s(1234 + k, uint32_t(i));
                Vec2 p(0.f);
                for (int d = 0; d <= dimension; ++d) p = s.get2D();
                points.push_back(p);
            }
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (const Vec2& p : points) cells.insert({int(p.x * float(1 << a)), int(p.y * float(1 << (k - a)))});
                EXPECT_EQ(int(cells.size()), n) << "interval shape " << a << " of " << k << ", pair " << dimension;
            }
        }
    }
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
    // Standard deviation of the mean of independent products is 1 / (12 sqrt(n)).
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
