// What tells a difference between samples from chance without asking how their values are distributed, and the numbers
// that describe such samples: tests on ranks, quartiles.
#pragma once
#include <span>
#include <vector>

namespace drc {

// The mean, and the values below which 5, 25, 50, 75 and 95 % of a sample lie: linear between its sorted values (type 7
// of Hyndman and Fan, "Sample Quantiles in Statistical Packages", 1996; NumPy's default).
struct Summary {
    double mean = 0, p5 = 0, q1 = 0, median = 0, q3 = 0, p95 = 0;
};
// All NaN if a value is NaN or there is none.
Summary summarise(std::span<const double> values);

// Smaller p-values are not distinguished from this one: it is an upper bound then.
inline constexpr double kSmallestP = 1e-300;

struct PairedComparison {
    double p = 1;  // two-sided: chance of so clear a difference between methods that are alike; 0: below kSmallestP
    double better = 0;  // share of pairs in which `a` is smaller
};

// Wilcoxon's signed-rank test of pairs (Wilcoxon, "Individual Comparisons by Ranking Methods", 1945), by its normal
// approximation: for some twenty pairs and more. Equal pairs are left out, equal differences share their ranks. NaN if
// a value is NaN. The sizes must be equal.
PairedComparison compareSmaller(std::span<const double> a, std::span<const double> b);

struct KruskalWallis {
    double h = 0;              // corrected for ties
    int degreesOfFreedom = 0;  // samples - 1
    double p = 1;              // chance of an h as large if all samples were of one distribution; 0: below kSmallestP
};

// Kruskal and Wallis, "Use of Ranks in One-Criterion Variance Analysis", 1952: whether independent samples, which need
// not have one size, come from one distribution; p from the chi-square distribution, for five values a sample and more.
// Equal values share their ranks. If all are equal, or fewer than two samples have values, h is 0 and p is 1. h and p
// are NaN if a value is NaN.
KruskalWallis kruskalWallis(std::span<const std::vector<double>> samples);

// Chance that a chi-square variable of that many degrees of freedom (at least 1) exceeds x.
double chiSquareUpperTail(double x, int degreesOfFreedom);

}  // namespace drc
