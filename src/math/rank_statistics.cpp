#include "math/rank_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drc {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool hasNaN(std::span<const double> values) {
    return std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

// Calls use(index, rank) for the elements of a sorted range. Ranks count from 1, and tied elements (those that are
// `equal`) get their mean rank. Returns the sum of t^3 - t over all groups of t tied elements, the correction by which
// ties reduce the variance.
template <typename Equal, typename Use>
double shareRanks(size_t count, const Equal& equal, const Use& use) {
    double ties = 0;
    for (size_t i = 0, j = 0; i < count; i = j) {
        while (j < count && equal(i, j)) ++j;
        for (size_t k = i; k < j; ++k) use(k, 0.5 * double(i + 1 + j));
        const auto tied = double(j - i);
        ties += tied * tied * tied - tied;
    }
    return ties;
}

// Denormal numbers have few significant digits, so p-values below kSmallestP are reported as 0.
double boundedP(double p) { return p < kSmallestP ? 0 : p; }

double quantile(std::span<const double> sorted, double share) {
    const double place = share * double(sorted.size() - 1);
    const auto below = std::min(size_t(place), sorted.size() - 1), above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Summary summarise(std::span<const double> values) {
    if (values.empty() || hasNaN(values)) return {kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
    std::vector<double> sorted(values.begin(), values.end());
    double sum = 0;
    for (const double v : sorted) sum += v;
    std::sort(sorted.begin(), sorted.end());
    return {sum / double(sorted.size()), quantile(sorted, 0.05), quantile(sorted, 0.25),
            quantile(sorted, 0.5),       quantile(sorted, 0.75), quantile(sorted, 0.95)};
}

PairedComparison compareSmaller(std::span<const double> a, std::span<const double> b) {
    std::vector<double> differences;
    size_t smaller = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const double d = b[i] - a[i];
        if (std::isnan(d)) return {kNaN, kNaN};
        smaller += d > 0;
        if (d != 0) differences.push_back(d);
    }
    const double better = a.empty() ? 0 : double(smaller) / double(a.size());
    if (differences.empty()) return {1, better};
    std::sort(differences.begin(), differences.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });

    const auto n = double(differences.size());
    double positiveRanks = 0;
    const double ties = shareRanks(
        differences.size(), [&](size_t i, size_t j) { return std::abs(differences[i]) == std::abs(differences[j]); },
        [&](size_t i, double rank) { positiveRanks += differences[i] > 0 ? rank : 0; });
    const double expected = n * (n + 1) / 4, variance = n * (n + 1) * (2 * n + 1) / 24 - ties / 48;
    return {boundedP(std::erfc(std::abs(positiveRanks - expected) / std::sqrt(2 * variance))), better};
}

KruskalWallis kruskalWallis(std::span<const std::vector<double>> samples) {
    std::vector<std::pair<double, size_t>> pooled;  // value, index of its sample
    KruskalWallis result;
    for (size_t s = 0; s < samples.size(); ++s) {
        if (hasNaN(samples[s])) result.h = result.p = kNaN;
        for (const double v : samples[s]) pooled.emplace_back(v, s);
        result.degreesOfFreedom += !samples[s].empty();
    }
    result.degreesOfFreedom = std::max(0, result.degreesOfFreedom - 1);
    if (std::isnan(result.h) || result.degreesOfFreedom == 0) return result;
    std::sort(pooled.begin(), pooled.end());

    std::vector<double> rankSums(samples.size());
    const double ties = shareRanks(
        pooled.size(), [&](size_t i, size_t j) { return pooled[i].first == pooled[j].first; },
        [&](size_t i, double rank) { rankSums[pooled[i].second] += rank; });
    const auto n = double(pooled.size());
    const double left = 1 - ties / (n * n * n - n);
    if (left <= 0) return result;
    // Sum of the squared deviations of the samples' mean ranks from the overall mean, weighted by sample size. The
    // usual formula subtracts two large numbers.
    double spread = 0;
    for (size_t s = 0; s < samples.size(); ++s) {
        if (samples[s].empty()) continue;
        const auto size = double(samples[s].size());
        const double offset = rankSums[s] / size - 0.5 * (n + 1);
        spread += size * offset * offset;
    }
    result.h = 12 / (n * (n + 1)) * spread / left;
    result.p = boundedP(chiSquareUpperTail(result.h, result.degreesOfFreedom));
    return result;
}

double chiSquareUpperTail(double x, int degreesOfFreedom) {
    if (!(x > 0)) return std::isnan(x) ? kNaN : 1;
    // Q(a, h), the upper regularised incomplete gamma function, by the recurrence Q(a + 1, h) = Q(a, h) + h^a e^-h /
    // Gamma(a + 1) (DLMF 8.8.6). All terms are positive, so it stays accurate far into the tail.
    const double h = x / 2, want = degreesOfFreedom / 2.0;
    double a = degreesOfFreedom % 2 ? 0.5 : 1;
    double q = degreesOfFreedom % 2 ? std::erfc(std::sqrt(h)) : std::exp(-h);
    for (; a < want; ++a) q += std::exp(a * std::log(h) - h - std::lgamma(a + 1));
    return std::min(1.0, q);
}

}  // namespace drc
