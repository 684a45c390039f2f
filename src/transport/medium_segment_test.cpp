#include "transport/medium_segment.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

const Medium kTinted{.sigmaA = Rgb(0.1f, 0.5f, 2), .sigmaS = Rgb(1, 0.4f, 0), .emission = Rgb(3, 2, 1), .g = 0.3f};

TEST(Medium, HasTheTransmittanceOfBeer) {
    const Rgb t = kTinted.transmittance(0.7f);
    EXPECT_NEAR(t.x, std::exp(-1.1 * 0.7), 1e-6);
    EXPECT_NEAR(t.y, std::exp(-0.9 * 0.7), 1e-6);
    EXPECT_NEAR(t.z, std::exp(-2.0 * 0.7), 1e-6);
    EXPECT_EQ(kTinted.transmittance(0), Rgb(1.f));
    EXPECT_EQ(kTinted.transmittance(kInfinity), Rgb(0.f));
    // A channel that nothing absorbs or scatters passes any distance.
    const Medium red{.sigmaS = Rgb(0, 1, 1)};
    EXPECT_EQ(red.transmittance(kInfinity), Rgb(1, 0, 0));
    EXPECT_EQ(red.albedo(), Rgb(0, 1, 1));
}

TEST(Medium, EmitsWhatTheIntegralOverItsLengthSays) {
    constexpr int kSteps = 20'000;
    constexpr double kLength = 1.7;
    const Rgb sigma = kTinted.sigmaT();
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int i = 0; i < kSteps; ++i)
            sum += std::exp(-double(sigma[c]) * (i + 0.5) * kLength / kSteps) * kLength / kSteps;
        EXPECT_NEAR(kTinted.emitted(float(kLength))[c], double(kTinted.sigmaA[c] * kTinted.emission[c]) * sum, 1e-5);
    }
    // A thin medium loses no digits.
    EXPECT_NEAR(kTinted.emitted(1e-6f).z / 2e-6, 1, 1e-4);
    EXPECT_EQ((Medium{.sigmaS = Rgb(1.f), .emission = Rgb(1.f)}).emitted(1), Rgb(0.f));
}

struct Mean {
    double sum = 0, squares = 0;
    void add(double x) {
        sum += x;
        squares += x * x;
    }
    // The distance from what is expected, in standard errors.
    double z(double expected, int n) const {
        const double mean = sum / n, variance = std::max(0.0, squares / n - mean * mean) / n;
        return std::abs(mean - expected) / std::sqrt(variance + 1e-16);
    }
};

// Unbiased, for each channel: both what arrives at the end, and the integral of any function of the place of scattering
// times transmittance and coefficient. That holds whatever the throughput, and for channels that do not scatter.
TEST(MediumSegment, IsUnbiasedInEveryChannel) {
    constexpr int kSamples = 400'000;
    const auto function = [](double t) { return 1 + std::sin(5 * t); };
    for (const Rgb& throughput : {Rgb(1.f), Rgb(1, 0.01f, 0), Rgb(0, 0, 1)}) {
        for (const float length : {0.05f, 1.5f, kInfinity}) {
            std::mt19937 rng(11);
            std::uniform_real_distribution<float> u(0, 1);
            Mean passed[3], scattered[3], passing;
            for (int i = 0; i < kSamples; ++i) {
                const float x = u(rng);
                const MediumSegment s = sampleSegment(kTinted, length, throughput, {x, u(rng)});
                for (int c = 0; c < 3; ++c) {
                    passed[c].add(s.scattered ? 0 : double(s.weight[c]));
                    scattered[c].add(s.scattered ? double(s.weight[c]) * function(double(*s.scattered)) : 0);
                }
                passing.add((s.scattered ? 0.0 : 1.0) - double(s.passing));
                if (s.scattered) {
                    EXPECT_TRUE(*s.scattered >= 0 && *s.scattered < length);
                }
                // No weight is large, also of channels that carry little.
                EXPECT_LE(maxComponent(s.weight), 20.01f);
            }
            for (int c = 0; c < 3; ++c) {
                const double sigma = double(kTinted.sigmaT()[c]), end = std::min(double(length), 60.0);
                double expected = 0;
                constexpr int kSteps = 200'000;
                for (int i = 0; i < kSteps; ++i) {
                    const double t = (i + 0.5) * end / kSteps;
                    expected += double(kTinted.sigmaS[c]) * std::exp(-sigma * t) * function(t) * end / kSteps;
                }
                EXPECT_LT(scattered[c].z(expected, kSamples), 4.5) << c << " " << length << " " << throughput.x;
                EXPECT_LT(passed[c].z(double(kTinted.transmittance(length)[c]), kSamples), 4.5) << c << " " << length;
            }
            EXPECT_LT(passing.z(0, kSamples), 4.5) << "the probability of arriving";
        }
    }
}

// Where nothing scatters, nothing is left to chance.
TEST(MediumSegment, IsExactInAbsorbingMedia) {
    const Medium tea{.sigmaA = Rgb(1, 2, 3)};
    const MediumSegment s = sampleSegment(tea, 0.5f, Rgb(1.f), {0.3f, 0.999f});
    EXPECT_FALSE(s.scattered);
    EXPECT_EQ(s.weight, tea.transmittance(0.5f));
    EXPECT_EQ(s.passing, 1);
}

}  // namespace
}  // namespace drc
