#include "reconstruct/noise_threshold.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

// The next estimate is due at the number of samples that should reach the threshold, bounded to these multiples of the
// number at the latest estimate: estimates take time, and the prediction may be wrong.
constexpr double kLeastGrowth = 1.15, kMostGrowth = 3;
// The slope in error ~ samples^-slope: the usual one of denoised pictures, and bounds on a slope from two estimates.
constexpr double kUsualSlope = 0.35, kLeastSlope = 0.15, kMostSlope = 0.6;

}  // namespace

NoiseThreshold::NoiseThreshold(double threshold) : threshold_(threshold), slope_(kUsualSlope) {}

bool NoiseThreshold::isDue(int samples) const {
    if (!(threshold_ > 0) || reached()) return false;
    if (!error_) return samples >= kFirst;
    return samples >= samples_ * std::clamp(*samplesNeeded() / samples_, kLeastGrowth, kMostGrowth);
}

void NoiseThreshold::estimated(int samples, double error) {
    if (error_ && *error_ > 0 && error > 0 && samples > samples_) {
        // The slope between two estimates is inaccurate if their numbers of samples are close, so it then gets a small
        // weight.
        const double growth = std::log(double(samples) / samples_), weight = std::min(1.0, growth / std::log(2.0));
        const double slope = std::clamp(std::log(*error_ / error) / growth, kLeastSlope, kMostSlope);
        slope_ += weight * (slope - slope_);
    }
    samples_ = samples;
    error_ = error;
}

std::optional<double> NoiseThreshold::samplesNeeded() const {
    if (!error_ || !(threshold_ > 0)) return {};
    return samples_ * std::pow(*error_ / threshold_, 1 / slope_);
}

}  // namespace drc
