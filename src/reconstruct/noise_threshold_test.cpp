#include "reconstruct/noise_threshold.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drc {
namespace {

// The samples at which the errors of a picture are estimated until they are small enough; error = samples^-slope.
std::vector<int> estimatesOf(double threshold, double slope) {
    NoiseThreshold t(threshold);
    std::vector<int> at;
    for (int samples = 1; samples < 1'000'000 && !t.reached(); ++samples)
        if (t.isDue(samples)) {
            t.estimated(samples, std::pow(samples, -slope));
            at.push_back(samples);
        }
    return at;
}

TEST(NoiseThreshold, IsReachedWithFewEstimatesAndLittleMore) {
    for (const double slope : {0.25, 0.35, 0.5})
        for (const double threshold : {0.2, 0.1, 0.05}) {
            const double needed = std::pow(threshold, -1 / slope);
            const std::vector<int> at = estimatesOf(threshold, slope);
            ASSERT_FALSE(at.empty());
            EXPECT_GE(at.back(), needed);
            // A factor of 1.2 in samples is one of 1.1 in the error, at most.
            EXPECT_LE(at.back(), std::max(8.0, 1.2 * needed) + 1) << slope << " " << threshold;
            EXPECT_LE(at.size(), 4 + std::log(at.back()) / std::log(3)) << slope << " " << threshold;
        }
}

// Errors that do not fall, as of a denoiser that smears, do not make it estimate all the time.
TEST(NoiseThreshold, EstimatesNowAndThenWhatDoesNotFall) { EXPECT_LE(estimatesOf(0.01, 0).size(), 12u); }

TEST(NoiseThreshold, TellsHowManySamplesAreNeeded) {
    NoiseThreshold t(0.05);
    EXPECT_FALSE(t.samplesNeeded());
    t.estimated(16, std::pow(16, -0.5));
    t.estimated(64, std::pow(64, -0.5));
    EXPECT_GT(*t.samplesNeeded(), 300);
    EXPECT_LT(*t.samplesNeeded(), 500);  // 400, when its slope is known
    t.estimated(400, 0.05);
    EXPECT_TRUE(t.reached());
    EXPECT_FALSE(t.isDue(100'000));
}

TEST(NoiseThreshold, ZeroIsNeverReached) {
    NoiseThreshold t(0);
    EXPECT_FALSE(t.isDue(1000));
    t.estimated(1000, 0.001);
    EXPECT_FALSE(t.reached());
    EXPECT_FALSE(t.samplesNeeded());
}

}  // namespace
}  // namespace drc
