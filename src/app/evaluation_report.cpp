#include "app/evaluation_report.h"

#include <fmt/core.h>

#include <cmath>

namespace drc {
namespace {

std::vector<double> valuesOf(const EvaluatedMethod& method, const Measure& measure) {
    std::vector<double> values;
    for (const ExampleScores& s : method.scores) values.push_back(measure.of(s));
    return values;
}

// a[i] and b[i] are of the same viewpoint.
void comparePair(const std::vector<double>& a, const std::vector<double>& b, size_t measure, PairReport& pair) {
    pair.firstMean[measure] = summarise(a).mean;
    pair.secondMean[measure] = summarise(b).mean;
    pair.paired[measure] = kMeasures[measure].higherIsBetter ? compareSmaller(b, a) : compareSmaller(a, b);
    const std::vector<double> samples[] = {a, b};
    pair.kruskalWallis[measure] = kruskalWallis(samples);
}

GroupReport reportOf(const EvaluatedGroup& group) {
    GroupReport report;
    const size_t methods = group.methods.size();
    for (const EvaluatedMethod& method : group.methods) report.methods.emplace_back().name = method.name;
    for (size_t a = methods; a-- > 0;)
        for (size_t b = a; b-- > 0;) {
            PairReport& pair = report.pairs.emplace_back();
            pair.first = group.methods[a].name;
            pair.second = group.methods[b].name;
        }
    for (size_t m = 0; m < kMeasureCount; ++m) {
        std::vector<std::vector<double>> values;
        for (const EvaluatedMethod& method : group.methods) values.push_back(valuesOf(method, kMeasures[m]));
        for (size_t i = 0; i < methods; ++i) report.methods[i].summary[m] = summarise(values[i]);
        report.all[m] = kruskalWallis(values);
        auto pair = report.pairs.begin();
        for (size_t a = methods; a-- > 0;)
            for (size_t b = a; b-- > 0;) comparePair(values[a], values[b], m, *pair++);
    }
    return report;
}

bool comparable(const EvaluatedGroup& a, size_t i, const EvaluatedGroup& b, size_t j) {
    constexpr size_t kWithoutNetwork = 2;  // none and gaussian
    return i < kWithoutNetwork || j < kWithoutNetwork ? a.methods[i].name == b.methods[j].name : true;
}

AcrossReport reportAcross(const EvaluatedGroup& a, const EvaluatedGroup& b) {
    AcrossReport report;
    const auto shared = sharedViewpoints(a, b);
    report.viewpoints = shared.size();
    if (shared.empty()) return report;
    for (size_t i = 0; i < a.methods.size(); ++i)
        for (size_t j = 0; j < b.methods.size(); ++j) {
            if (!comparable(a, i, b, j)) continue;
            PairReport& pair = report.pairs.emplace_back();
            pair.first = a.methods[i].name;
            pair.second = b.methods[j].name;
            for (size_t m = 0; m < kMeasureCount; ++m) {
                std::vector<double> x, y;
                for (const auto& [inA, inB] : shared) {
                    x.push_back(kMeasures[m].of(a.methods[i].scores[inA]));
                    y.push_back(kMeasures[m].of(b.methods[j].scores[inB]));
                }
                comparePair(x, y, m, pair);
            }
        }
    return report;
}

}  // namespace

EvaluationReport makeReport(const Evaluation& evaluation) {
    EvaluationReport report;
    const std::vector<EvaluatedGroup>& groups = evaluation.groups;
    for (const EvaluatedGroup& group : groups) report.groups.push_back(reportOf(group));
    for (size_t a = 0; a < groups.size(); ++a)
        for (size_t b = a + 1; b < groups.size(); ++b) {
            AcrossReport across = reportAcross(groups[a], groups[b]);
            across.first = a;
            across.second = b;
            if (across.viewpoints > 0) report.across.push_back(std::move(across));
        }
    return report;
}

std::string formatP(double p) {
    if (std::isnan(p)) return "nan";
    return p < kSmallestP ? fmt::format("< {:.0e}", kSmallestP) : fmt::format("{:#.2g}", p);
}

}  // namespace drc
