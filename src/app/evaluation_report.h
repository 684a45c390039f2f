// The numbers of an evaluation: each method's measures over the examples, and tests of their differences. The table
// and the JSON of `drc evaluate` show them, and so does the page that the laboratory makes of the JSON.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "app/evaluation.h"
#include "math/rank_statistics.h"

namespace drc {

// One column of the tables: a measure (map_evaluation.h), of maps as rendered or scaled to equal energy.
struct Measure {
    const char *group, *key;  // as in the JSON
    const char* title;        // as in the tables
    const char* groupTitle;
    MapScores ExampleScores::*energy;
    double MapScores::*value;
    bool higherIsBetter;
    double of(const ExampleScores& scores) const { return (scores.*energy).*value; }
};
inline constexpr size_t kMeasureCount = 6;
inline constexpr std::array<Measure, kMeasureCount> kMeasures{{
    {"as_rendered", "l1", "L1", "as rendered", &ExampleScores::asRendered, &MapScores::l1, false},
    {"as_rendered", "ssim", "SSIM", "as rendered", &ExampleScores::asRendered, &MapScores::ssim, true},
    {"as_rendered", "irradiance_relmse", "irradiance", "as rendered", &ExampleScores::asRendered,
     &MapScores::irradiance, false},
    {"equal_energy", "l1", "L1", "equal energy", &ExampleScores::equalEnergy, &MapScores::l1, false},
    {"equal_energy", "ssim", "SSIM", "equal energy", &ExampleScores::equalEnergy, &MapScores::ssim, true},
    {"equal_energy", "irradiance_relmse", "irradiance", "equal energy", &ExampleScores::equalEnergy,
     &MapScores::irradiance, false},
}};
template <typename T>
using PerMeasure = std::array<T, kMeasureCount>;

struct MethodReport {
    std::string name;
    PerMeasure<Summary> summary;
};

// Compares two methods over the same viewpoints, in one projection or across two.
struct PairReport {
    std::string first, second;
    PerMeasure<double> firstMean, secondMean;
    PerMeasure<PairedComparison> paired;      // better: share of examples in which the first method is better
    PerMeasure<KruskalWallis> kruskalWallis;  // of the two as unpaired samples, as in the paper
};

struct GroupReport {
    std::vector<MethodReport> methods;
    PerMeasure<KruskalWallis> all;  // all methods together
    std::vector<PairReport> pairs;  // each method against each method before it, beginning with the last
};

// Two groups that share viewpoints; groups are named by their index in Evaluation::groups.
struct AcrossReport {
    size_t first = 0, second = 0, viewpoints = 0;
    std::vector<PairReport> pairs;  // none, gaussian, and each network of one group with each of the other
};

struct EvaluationReport {
    std::vector<GroupReport> groups;  // as Evaluation::groups
    std::vector<AcrossReport> across;
};

EvaluationReport makeReport(const Evaluation& evaluation);

// "0.0012", "1.3e-82", "< 1e-300".
std::string formatP(double p);

}  // namespace drc
