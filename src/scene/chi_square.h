// Pearson's chi-square test of whether samples follow their claimed pdf, for tests. The bins cover the sphere of
// directions; bins with a small expected count are pooled.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "math/rank_statistics.h"
#include "math/vec.h"

namespace drc::test {

// Number of chi-square tests in the whole suite, rounded up. Each test is held to a significance level of 1 % divided
// by this (Bonferroni), so that a correct program fails a run of the suite for one seed in a hundred. Seeds are fixed.
inline constexpr double kChiSquareTests = 500;
inline constexpr double kChiSquareLevel = 0.01 / kChiSquareTests;

struct ChiSquare {
    double statistic = 0;
    int degreesOfFreedom = 0;
    double pValue = 1;
    double pdfIntegral = 0;
};

// Integral of g over [x0, x1] x [y0, y1], by Gauss-Legendre quadrature on recursively quartered cells.
template <typename F>
double integrateCell(const F& g, double x0, double x1, double y0, double y1, int depth, double tolerance = 1e-6) {
    constexpr int kMinDepth = 1, kMaxDepth = 9;
    const auto gauss = [&](double ax, double bx, double ay, double by) {
        static constexpr double node[2] = {0.33998104358485626, 0.86113631159405258};
        static constexpr double weight[2] = {0.65214515486254614, 0.34785484513745386};
        double sum = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                sum += weight[i / 2] * weight[j / 2] *
                       g(0.5 * (ax + bx) + 0.5 * (bx - ax) * (i % 2 ? 1 : -1) * node[i / 2],
                         0.5 * (ay + by) + 0.5 * (by - ay) * (j % 2 ? 1 : -1) * node[j / 2]);
        return sum * 0.25 * (bx - ax) * (by - ay);
    };
    const double xm = 0.5 * (x0 + x1), ym = 0.5 * (y0 + y1);
    const double coarse = gauss(x0, x1, y0, y1);
    const double fine = gauss(x0, xm, y0, ym) + gauss(xm, x1, y0, ym) + gauss(x0, xm, ym, y1) + gauss(xm, x1, ym, y1);
    if (depth >= kMaxDepth || (depth >= kMinDepth && std::abs(fine - coarse) < tolerance)) return fine;
    return integrateCell(g, x0, xm, y0, ym, depth + 1, tolerance) +
           integrateCell(g, xm, x1, y0, ym, depth + 1, tolerance) +
           integrateCell(g, x0, xm, ym, y1, depth + 1, tolerance) +
           integrateCell(g, xm, x1, ym, y1, depth + 1, tolerance);
}

// Integral of g over solid angle, over one bin of the sphere: kZBins equal intervals of z times kPhiBins of the
// azimuth.
inline constexpr int kZBins = 16, kPhiBins = 24;
template <typename F>
double integrateBin(const F& g, int iz, int iphi, double tolerance = 1e-6) {
    const auto inCylinder = [&](double z, double phi) {
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        return double(g(Vec3(float(r * std::cos(phi)), float(r * std::sin(phi)), float(z))));
    };
    const double dz = 2.0 / kZBins, dphi = 2 * std::numbers::pi / kPhiBins;
    return integrateCell(inCylinder, -1 + iz * dz, -1 + (iz + 1) * dz, iphi * dphi, (iphi + 1) * dphi, 0, tolerance);
}
template <typename F>
double integrateSphere(const F& g, double tolerance = 1e-6) {
    double sum = 0;
    for (int iz = 0; iz < kZBins; ++iz)
        for (int iphi = 0; iphi < kPhiBins; ++iphi) sum += integrateBin(g, iz, iphi, tolerance);
    return sum;
}

// sample(rng) returns a unit vector or none; pdf(w) is its density per solid angle. The probability of none must be one
// minus the integral of the pdf. tolerance: absolute error at which a cell's integral is refined no further; pdfs with
// discontinuities need a larger one.
template <typename Sample, typename Pdf>
ChiSquare chiSquareTest(const Sample& sample, const Pdf& pdf, int samples, uint32_t seed, double tolerance = 1e-6) {
    std::mt19937 rng(seed);
    std::array<double, kZBins * kPhiBins + 1> observed{}, expected{};
    for (int i = 0; i < samples; ++i) {
        const std::optional<Vec3> w = sample(rng);
        if (!w) {
            ++observed.back();
            continue;
        }
        const int iz = std::clamp(int((w->z + 1) * (0.5f * kZBins)), 0, kZBins - 1);
        float phi = std::atan2(w->y, w->x);
        if (phi < 0) phi += 2 * kPi;
        ++observed[iz * kPhiBins + std::clamp(int(phi * (kPhiBins / (2 * kPi))), 0, kPhiBins - 1)];
    }
    ChiSquare result;
    for (int iz = 0; iz < kZBins; ++iz)
        for (int iphi = 0; iphi < kPhiBins; ++iphi) {
            const double p = integrateBin(pdf, iz, iphi, tolerance);
            result.pdfIntegral += p;
            expected[iz * kPhiBins + iphi] = p * samples;
        }
    expected.back() = std::max(0.0, 1 - result.pdfIntegral) * samples;

    double pooledObserved = 0, pooledExpected = 0;
    int cells = 0;
    const auto count = [&](double o, double e) {
        result.statistic += (o - e) * (o - e) / e;
        ++cells;
    };
    for (size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= 5) {
            count(observed[i], expected[i]);
        } else {
            pooledObserved += observed[i];
            pooledExpected += expected[i];
        }
    }
    // Samples where the pdf is zero are an error, except for a few that rounding at the edge of a bin explains.
    if (pooledExpected >= 5)
        count(pooledObserved, pooledExpected);
    else if (pooledObserved > pooledExpected + 5 * std::sqrt(pooledExpected + 1) + 3)
        result.statistic = kInfinity;
    result.degreesOfFreedom = std::max(1, cells - 1);
    result.pValue = std::isfinite(result.statistic) ? chiSquareUpperTail(result.statistic, result.degreesOfFreedom) : 0;
    return result;
}

}  // namespace drc::test
