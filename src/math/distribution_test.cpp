#include "math/distribution.h"

#include <gtest/gtest.h>

#include "math/rng.h"

namespace drc {
namespace {

TEST(Distribution1D, SamplesInProportion) {
    const std::vector<float> f = {0, 1, 3, 0, 4, 0};
    const Distribution1D d(f);
    EXPECT_NEAR(d.integral(), 8 / 6.0, 1e-12);
    std::vector<double> counts(f.size());
    const int n = 8000;
    for (int i = 0; i < n; ++i) {
        const float u = (i + 0.5f) / n;
        const Sample1D s = d.sampleContinuous(u);
        EXPECT_GE(s.x, s.index / 6.f - 1e-7f);
        EXPECT_LE(s.x, (s.index + 1) / 6.f);
        EXPECT_EQ(s.pdf, d.pdf(s.x));
        EXPECT_NEAR(s.pdf, f[s.index] / (8 / 6.0), 1e-6);
        const DiscreteSample k = d.sampleDiscrete(u);
        EXPECT_EQ(k.index, s.index);
        EXPECT_EQ(k.probability, d.probability(k.index));
        counts[k.index] += 1;
    }
    for (size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(counts[i] / n, f[i] / 8, 1e-3);
}

TEST(Distribution1D, IsTheInverseOfItsCumulative) {
    const Distribution1D d(std::vector<float>{1, 3});
    EXPECT_NEAR(d.sampleContinuous(0.125f).x, 0.25, 1e-6);
    EXPECT_NEAR(d.sampleContinuous(0.625f).x, 0.75, 1e-6);
    EXPECT_NEAR(d.sampleDiscrete(0.625f).uRemapped, 0.5, 1e-6);
    EXPECT_EQ(d.sampleDiscrete(0.625f).index, 1);
}

TEST(Distribution1D, EdgesNeverLandInEmptyCells) {
    const Distribution1D d(std::vector<float>{0, 0, 0.1f, 0, 0.7f, 0, 0});
    for (float u : {0.f, 1e-30f, 0.125f, std::nextafter(0.125f, 1.f), 0.5f, kOneMinusEpsilon, 1.f}) {
        const Sample1D s = d.sampleContinuous(u);
        EXPECT_GT(s.pdf, 0);
        EXPECT_EQ(s.pdf, d.pdf(s.x));
        EXPECT_LT(s.x, 1);
    }
}

TEST(Distribution1D, ZerosAndNonsense) {
    const Distribution1D zero(std::vector<float>{0, 0});
    EXPECT_EQ(zero.integral(), 0);
    EXPECT_EQ(zero.pdf(0.3f), 1);
    EXPECT_EQ(zero.sampleContinuous(0.75f).x, 0.75f);
    EXPECT_EQ(Distribution1D().sampleContinuous(0.25f).x, 0.25f);
    const Distribution1D odd(std::vector<float>{NAN, -1, 2, kInfinity});
    EXPECT_EQ(odd.probability(2), 1);
}

TEST(Distribution1D, HugeRange) {
    // A small sun in a dim sky: the dim cells must stay reachable, and pdf() must agree with sampling.
    std::vector<float> f(4096, 1.f);
    f[100] = 1e9f;
    const Distribution1D d(f);
    double sum = 0;
    for (int i = 0; i < 4096; ++i) sum += d.probability(i);
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_NEAR(d.probability(4000) * 1e9, 1, 1e-3);
}

TEST(Distribution2D, DensityIntegratesToOneAndMatchesSampling) {
    const int w = 5, h = 3;
    const std::vector<float> f = {1, 2, 0, 4, 5, 0, 0, 0, 0, 0, 3, 1, 7, 0, 2};
    const Distribution2D d(f, w, h);
    double total = 0;
    for (float v : f) total += v;
    EXPECT_NEAR(d.integral(), total / 15, 1e-6);
    double integral = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const float p = d.pdf(x, y);
            EXPECT_NEAR(p, f[y * w + x] / total * 15, 1e-5);
            integral += p / 15;
        }
    EXPECT_NEAR(integral, 1, 1e-6);
    Pcg32 rng(1);
    std::vector<double> counts(f.size());
    const int n = 200000;
    for (int i = 0; i < n; ++i) {
        const Sample2D s = d.sample(rng.nextVec2());
        ASSERT_EQ(s.pdf, d.pdf(s.x, s.y));
        counts[s.y * w + s.x] += 1;
    }
    double chiSquare = 0;
    for (size_t i = 0; i < f.size(); ++i) {
        const double expected = n * f[i] / total;
        if (expected == 0) {
            EXPECT_EQ(counts[i], 0);
        } else {
            chiSquare += sqr(float(counts[i] - expected)) / expected;
        }
    }
    EXPECT_LT(chiSquare, 24.3);  // 99.9 % quantile for 7 degrees of freedom
}

TEST(Distribution2D, InverseGivesBackTheRandomNumbers) {
    const std::vector<float> f = {1, 2, 0, 4, 5, 0, 3, 1, 7, 0, 2, 6};
    const Distribution2D d(f, 4, 3);
    Pcg32 rng(2);
    for (int i = 0; i < 10000; ++i) {
        const Vec2 u = rng.nextVec2();
        const Sample2D s = d.sample(u);
        EXPECT_LT((d.inverse(s.x, s.y, s.local) - u).length(), 1e-6f);
    }
}

}  // namespace
}  // namespace drc
