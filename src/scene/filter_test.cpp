#include "scene/filter.h"

#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

struct Case {
    const char* name;
    FilterPtr filter;
    bool negative;  // has negative lobes
};

std::vector<Case> cases() {
    return {{"box", makeBoxFilter(Vec2(0.5f, 0.5f)), false},
            {"box, wide", makeBoxFilter(Vec2(2, 1)), false},
            {"triangle", makeTriangleFilter(Vec2(2, 1.5f)), false},
            {"gaussian", makeGaussianFilter(Vec2(2, 2), 2), false},
            {"gaussian, uneven", makeGaussianFilter(Vec2(1.5f, 3), 0.5f), false},
            {"mitchell", makeMitchellFilter(Vec2(2, 2), 1 / 3.f, 1 / 3.f), true},
            {"mitchell, uneven", makeMitchellFilter(Vec2(3, 1), 0, 0.5f), true},
            {"sinc", makeSincFilter(Vec2(4, 4), 3), true}};
}

TEST(Filter, ValuesOfPbrt) {
    EXPECT_EQ(makeBoxFilter(Vec2(0.5f, 0.5f))->eval(Vec2(0.4f, -0.4f)), 1);
    EXPECT_EQ(makeTriangleFilter(Vec2(2, 2))->eval(Vec2(0.5f, -1)), 1.5f);
    const double edge = std::exp(-2 * 4.0);
    EXPECT_NEAR(makeGaussianFilter(Vec2(2, 2), 2)->eval(Vec2(1, 0.5f)),
                (std::exp(-2.0) - edge) * (std::exp(-0.5) - edge), 1e-6);
    // Mitchell with B = C = 1/3 along an axis: 8/9 at the centre, 1/18 at half the radius, -5/144 at three quarters.
    const FilterPtr mitchell = makeMitchellFilter(Vec2(2, 2), 1 / 3.f, 1 / 3.f);
    EXPECT_NEAR(mitchell->eval(Vec2(0, 0)), 64 / 81.0, 1e-6);
    EXPECT_NEAR(mitchell->eval(Vec2(1, 0)), 8 / 9.0 / 18, 1e-6);
    EXPECT_NEAR(mitchell->eval(Vec2(1.5f, 0)), 8 / 9.0 * (-5 / 144.0), 1e-6);
    EXPECT_NEAR(mitchell->eval(Vec2(2, 0)), 0, 1e-6);
    const FilterPtr sinc = makeSincFilter(Vec2(4, 4), 3);
    EXPECT_NEAR(sinc->eval(Vec2(0, 0)), 1, 1e-6);
    EXPECT_NEAR(sinc->eval(Vec2(1.5f, 0)), std::sin(1.5 * kPi) / (1.5 * kPi) * std::sin(0.5 * kPi) / (0.5 * kPi), 1e-6);
    for (const Case& c : cases()) EXPECT_EQ(c.filter->eval(c.filter->radius() * 1.01f), 0) << c.name;
}

// The mean of weight times a test function must equal the filter's normalised moment, so that reconstruction with these
// samples is correct; and the weights must be constant in magnitude.
TEST(Filter, SamplesReproduceTheFilter) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Vec2 r = c.filter->radius();
        const auto g = [&](const Vec2& p, int k) {
            const double x = p.x / r.x, y = p.y / r.y;
            return k == 0 ? 1 : k == 1 ? x : k == 2 ? x * x : k == 3 ? y * y : std::cos(3 * x + 2 * y);
        };
        const int grid = 400;
        double exact[5] = {};
        double absolute = 0;
        for (int j = 0; j < grid; ++j)
            for (int i = 0; i < grid; ++i) {
                const Vec2 p((2 * (i + 0.5f) / grid - 1) * r.x, (2 * (j + 0.5f) / grid - 1) * r.y);
                const double f = c.filter->eval(p);
                absolute += std::abs(f);
                for (int k = 0; k < 5; ++k) exact[k] += f * g(p, k);
            }
        Pcg32 rng(8);
        RunningMean estimate[5];
        const int n = 512;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const Vec2 u = (Vec2(float(i), float(j)) + rng.nextVec2()) / n;
                const FilterSample s = c.filter->sample(u, rng.nextUint(1 << 30), 0);
                ASSERT_LE(std::abs(s.offset.x), r.x);
                ASSERT_LE(std::abs(s.offset.y), r.y);
                ASSERT_TRUE(c.negative || s.weight >= 0);
                // In cells of the table where the filter crosses zero, a sample may be on the other side.
                const double value = double(c.filter->eval(s.offset));
                ASSERT_TRUE(s.weight * value * exact[0] >= 0 || std::abs(value) < 0.01) << value;
                EXPECT_NEAR(std::abs(s.weight), absolute / std::abs(exact[0]), 0.02);
                for (int k = 0; k < 5; ++k) estimate[k].add(s.weight * g(s.offset, k));
            }
        for (int k = 0; k < 5; ++k) EXPECT_NEAR(estimate[k].mean(), exact[k] / exact[0], 8e-3) << k;
    }
}

// Histogram of samples against |f|, for filters sampled analytically and by table.
TEST(Filter, DensityIsProportionalToTheMagnitude) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        constexpr int kBins = 8, kFine = 64;
        const Vec2 r = c.filter->radius();
        double expected[kBins][kBins] = {}, counts[kBins][kBins] = {}, total = 0;
        for (int j = 0; j < kBins * kFine; ++j)
            for (int i = 0; i < kBins * kFine; ++i) {
                const Vec2 p((2 * (i + 0.5f) / (kBins * kFine) - 1) * r.x,
                             (2 * (j + 0.5f) / (kBins * kFine) - 1) * r.y);
                const double f = std::abs(c.filter->eval(p));
                expected[j / kFine][i / kFine] += f;
                total += f;
            }
        Pcg32 rng(2);
        const int n = 100000;
        for (int k = 0; k < n; ++k) {
            const Vec2 p = c.filter->sample(rng.nextVec2(), uint32_t(k), 0).offset;
            const int i = std::min(kBins - 1, int((p.x / r.x + 1) / 2 * kBins)),
                      j = std::min(kBins - 1, int((p.y / r.y + 1) / 2 * kBins));
            counts[j][i] += 1;
        }
        double chiSquare = 0;
        int degrees = -1;
        for (int j = 0; j < kBins; ++j)
            for (int i = 0; i < kBins; ++i) {
                const double e = n * expected[j][i] / total;
                if (e < 5) continue;
                chiSquare += (counts[j][i] - e) * (counts[j][i] - e) / e;
                ++degrees;
            }
        EXPECT_LT(chiSquare, degrees + 4 * std::sqrt(2.0 * degrees));
    }
}

// A pixel's mean is its weighted samples' sum, divided by the sum of their weights. After any number of samples, and in
// each of the groups into which films divide them.
TEST(Filter, WeightsNeverCancel) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        Pcg32 rng(3);
        bool negative = false;
        for (uint64_t pixel = 0; pixel < 300; ++pixel) {
            double sum = 0, ofGroups[Filter::kGroups] = {};
            for (uint32_t i = 0; i < 300; ++i) {
                const double weight = double(c.filter->sample(rng.nextVec2(), i, pixel).weight);
                negative = negative || weight < 0;
                sum += weight;
                double& ofGroup = ofGroups[i % Filter::kGroups] += weight;
                ASSERT_GT(sum, 0.33 * (i + 1)) << i;
                ASSERT_GT(ofGroup, 0.33 * (i / Filter::kGroups + 1)) << i;
            }
        }
        EXPECT_EQ(negative, c.negative);
    }
}

// Over many pixels, a share of the samples that is the lobes' own is negative, soon.
TEST(Filter, NegativeSamplesComeSoon) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        for (const uint32_t samples : {16u, 64u, 256u}) {
            double sum = 0;
            constexpr uint64_t kPixels = 20'000;
            for (uint64_t pixel = 0; pixel < kPixels; ++pixel)
                for (uint32_t i = 0; i < samples; ++i)
                    sum += double(c.filter->sample(Vec2(0.5f, 0.5f), i, pixel).weight);
            // The sum of the weights would be their number, if those that are negative were not late by up to two of
            // each group.
            const double late = 2.5 * Filter::kGroups * (double(c.filter->sample(Vec2(0.5f, 0.5f), 0, 0).weight) - 1);
            EXPECT_NEAR(sum / kPixels, samples, late + 0.02 * samples) << samples;
        }
    }
}

}  // namespace
}  // namespace drc
