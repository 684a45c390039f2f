// A Z-test of whether two pictures, whose pixels are means of independent samples, have the same expectation.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "math/vec.h"

namespace drc::test {

// Mean, variance of the mean, and degrees of freedom of that variance, for each pixel and channel.
struct Estimate {
    std::vector<double> mean, variance, freedom;  // [pixels * 3]
};

// Variance of a sum or difference, and its degrees of freedom (Welch-Satterthwaite).
struct Combined {
    double variance, freedom;
};
inline Combined combine(const Estimate& a, const Estimate& b, size_t i) {
    const double va = a.variance[i], vb = b.variance[i], v = va + vb;
    const double d = va * va / a.freedom[i] + vb * vb / b.freedom[i];
    return {v, d > 0 ? v * v / d : 1e9};
}

// Runs sample(pixel, i) for i in [0, samples) at every pixel. Each `group` consecutive samples are averaged before the
// variance is computed: taking stratified samples as independent overestimates the variance of their mean.
inline Estimate estimate(int pixels, int samples, int group, const std::function<Rgb(int pixel, int i)>& sample) {
    Estimate e;
    e.mean.resize(size_t(pixels) * 3);
    e.variance.resize(size_t(pixels) * 3);
    e.freedom.assign(size_t(pixels) * 3, samples / group - 1);
    parallelFor(0, pixels, 1, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            double sum[3] = {}, squares[3] = {};
            const int groups = samples / group;
            for (int g = 0; g < groups; ++g) {
                Rgb mean(0.f);
                for (int i = 0; i < group; ++i) mean += sample(p, g * group + i) * (1.f / float(group));
                for (int c = 0; c < 3; ++c) {
                    sum[c] += mean[c];
                    squares[c] += double(mean[c]) * mean[c];
                }
            }
            for (int c = 0; c < 3; ++c) {
                const double m = sum[c] / groups;
                e.mean[size_t(p * 3 + c)] = m;
                e.variance[size_t(p * 3 + c)] = std::max(0.0, squares[c] / groups - m * m) / (groups - 1);
            }
        }
    });
    return e;
}

// Estimate from independent pictures: [picture][pixel].
inline Estimate estimateOf(const std::vector<std::vector<Rgb>>& pictures) {
    return estimate(int(pictures[0].size()), int(pictures.size()), 1,
                    [&](int pixel, int i) { return pictures[size_t(i)][size_t(pixel)]; });
}

// Estimate of the mean over all pixels from independent pictures. Valid although the pixels of a picture depend on each
// other.
inline Estimate estimateOfMeans(const std::vector<std::vector<Rgb>>& pictures) {
    return estimate(1, int(pictures.size()), 1, [&](int, int i) {
        Rgb sum(0.f);
        for (const Rgb& value : pictures[size_t(i)]) sum += value;
        return sum * (1.f / float(pictures[size_t(i)].size()));
    });
}

// `a`, moved towards `b` by at most this share of b's mean. Tests with it find differences that are larger than that.
inline Estimate allowing(double share, Estimate a, const Estimate& b) {
    for (size_t i = 0; i < a.mean.size(); ++i) {
        const double most = share * std::abs(b.mean[i]);
        a.mean[i] += std::clamp(b.mean[i] - a.mean[i], -most, most);
    }
    return a;
}

struct ZResult {
    double worst = 0;           // largest |z| over pixels and channels
    double meanSquare = 0;      // of z; 1 if the variances are right and the expectations are equal
    double meanDifference = 0;  // of the mean over the whole picture, in standard deviations
    double bound = 0;           // of `worst` and `meanDifference`; exceeded by chance in one of a thousand tests
    int tests = 0;
};

inline ZResult zTest(const Estimate& a, const Estimate& b) {
    ZResult r;
    double difference = 0, variance = 0;
    for (size_t i = 0; i < a.mean.size(); ++i) {
        const auto [v, freedom] = combine(a, b, i);
        const double d = a.mean[i] - b.mean[i];
        difference += d;
        variance += v;
        if (v <= 1e-14) continue;
        // d / sqrt(v) follows Student's t distribution; Wallace's approximation (1959) converts it to a standard normal
        // deviate.
        const double z = (8 * freedom + 1) / (8 * freedom + 3) * std::sqrt(freedom * std::log1p(d * d / (v * freedom)));
        r.worst = std::max(r.worst, z);
        r.meanSquare += z * z;
        ++r.tests;
    }
    r.meanSquare /= std::max(1, r.tests);
    r.meanDifference = variance > 0 ? std::abs(difference) / std::sqrt(variance) : 0;
    // Sidak's correction for multiple tests, by the asymptotic expansion of the normal tail: P(|z| > x) = sqrt(2 / pi)
    // exp(-x^2 / 2) / x. The channels of a pixel are correlated, which only makes the bound more generous.
    const double p = 1e-3 / std::max(1, r.tests);
    double x = 3;
    for (int k = 0; k < 50; ++k) x = std::sqrt(-2 * std::log(p * x * std::sqrt(std::numbers::pi / 2)));
    r.bound = x;
    return r;
}

// correlated: pixels share maps, so only few of the z values are independent. Their mean square then varies more, and
// their mean over the picture is not tested.
inline void expectSame(const Estimate& a, const Estimate& b, const std::string& what, bool correlated = false) {
    const ZResult z = zTest(a, b);
    EXPECT_GT(z.tests, 100) << what << ": nothing was compared";
    EXPECT_LT(z.worst, z.bound) << what;
    if (!correlated) {
        EXPECT_LT(z.meanDifference, 4) << what << ": the pictures' means differ";
    }
    EXPECT_LT(z.meanSquare, correlated ? 2.5 : 1.5) << what;
}

// Means over whole pictures (estimateOfMeans), precise enough to tell two per cent apart. rounding: of the means.
inline void expectSameMeans(const Estimate& expected, const Estimate& found, double rounding = 1e-6) {
    for (size_t c = 0; c < 3; ++c) {
        const double sigma = std::sqrt(expected.variance[c] + found.variance[c]);
        EXPECT_NEAR(found.mean[c], expected.mean[c], 5 * sigma + rounding);
        EXPECT_LT(sigma, 0.02 * expected.mean[c]);
    }
}

inline Estimate constantEstimate(size_t size, double value) {
    return {std::vector<double>(size, value), std::vector<double>(size, 0), std::vector<double>(size, 1)};
}

}  // namespace drc::test
