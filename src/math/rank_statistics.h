// Nonparametric statistics: rank tests, which tell a difference between samples from chance without assuming a
// distribution, and quartiles.
#pragma once
#include <span>
#include <vector>

namespace drc {

// The mean and the 5, 25, 50, 75 and 95 % quantiles of a sample, interpolated linearly between the sorted values (type
// 7 of Hyndman and Fan, "Sample Quantiles in Statistical Packages", 1996; the default of NumPy).
struct Summary {
    double mean = 0, p5 = 0, q1 = 0, median = 0, q3 = 0, p95 = 0;
};
// All members are NaN if there are no values or one is NaN.
Summary summarise(std::span<const double> values);

// Smaller p-values are reported as 0; this is then their upper bound.
inline constexpr double kSmallestP = 1e-300;

struct PairedComparison {
    double p = 1;       // two-sided p-value: chance of at least this difference for equal methods; 0: below kSmallestP
    double better = 0;  // share of the pairs in which `a` is smaller
};

// Wilcoxon's signed-rank test for paired samples (Wilcoxon, "Individual Comparisons by Ranking Methods", 1945) in the
// normal approximation, which is accurate for about twenty pairs and more. Pairs without a difference are left out, and
// tied differences share their mean rank. a and b must have the same size. NaN if a value is NaN.
PairedComparison compareSmaller(std::span<const double> a, std::span<const double> b);

struct KruskalWallis {
    double h = 0;              // corrected for ties
    int degreesOfFreedom = 0;  // samples - 1
    double p = 1;  // chance of an h at least this large if all samples have one distribution; 0: below kSmallestP
};

// Whether independent samples, possibly of different sizes, come from one distribution (Kruskal and Wallis, "Use of
// Ranks in One-Criterion Variance Analysis", 1952). p is taken from the chi-square distribution, which is accurate for
// five values per sample and more. Tied values share their mean rank. If all values are equal, or fewer than two
// samples have any, h is 0 and p is 1. h and p are NaN if a value is NaN.
KruskalWallis kruskalWallis(std::span<const std::vector<double>> samples);

// Chance that a chi-square variable with the given degrees of freedom (at least 1) exceeds x.
double chiSquareUpperTail(double x, int degreesOfFreedom);

}  // namespace drc
