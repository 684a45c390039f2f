#include <cmath>
#include <nlohmann/json.hpp>

#include "app/evaluation_text.h"

namespace drc {
namespace {

using OrderedJson = nlohmann::ordered_json;

// JSON has no NaN: it becomes null.
OrderedJson finiteOrNull(double x) { return std::isfinite(x) ? OrderedJson(x) : OrderedJson(nullptr); }

OrderedJson pValue(double p) {
    if (p < kSmallestP) return {{"p", kSmallestP}, {"p_is_bound", true}};
    return {{"p", finiteOrNull(p)}};
}

OrderedJson toJson(const Summary& s) {
    return {{"mean", finiteOrNull(s.mean)}, {"median", finiteOrNull(s.median)}, {"q1", finiteOrNull(s.q1)},
            {"q3", finiteOrNull(s.q3)},     {"p5", finiteOrNull(s.p5)},         {"p95", finiteOrNull(s.p95)}};
}

OrderedJson toJson(const KruskalWallis& k) {
    OrderedJson json{{"h", finiteOrNull(k.h)}, {"degrees_of_freedom", k.degreesOfFreedom}};
    json.update(pValue(k.p));
    return json;
}

// {"as_rendered": {"l1": of(0), ...}, "equal_energy": ...}
template <typename F>
OrderedJson perMeasure(const F& of) {
    OrderedJson json;
    for (size_t m = 0; m < kMeasureCount; ++m) json[kMeasures[m].group][kMeasures[m].key] = of(m);
    return json;
}

OrderedJson toJson(const PairReport& pair, bool withMeans) {
    OrderedJson json{{"first", pair.first}, {"second", pair.second}};
    json.update(perMeasure([&](size_t m) {
        OrderedJson cell;
        if (withMeans)
            cell = {{"first_mean", finiteOrNull(pair.firstMean[m])}, {"second_mean", finiteOrNull(pair.secondMean[m])}};
        cell["first_better"] = finiteOrNull(pair.paired[m].better);
        cell["wilcoxon"] = pValue(pair.paired[m].p);
        cell["kruskal_wallis"] = toJson(pair.kruskalWallis[m]);
        return cell;
    }));
    return json;
}

OrderedJson toJson(const EvaluatedGroup& group, const GroupReport& report) {
    OrderedJson json{{"name", group.name()},
                     {"projection", projectionName(group.layout.projection())},
                     {"map_size", group.layout.size()},
                     {"examples", group.examples.size()},
                     {"files", OrderedJson::array()}};
    for (const EvaluatedFile& file : group.files)
        json["files"].push_back({{"path", file.source->path()},
                                 {"scene", file.source->scene()},
                                 {"examples", file.source->count()},
                                 {"inputs", file.inputs}});
    for (const MethodReport& method : report.methods)
        json["methods"][method.name] = perMeasure([&](size_t m) { return toJson(method.summary[m]); });
    json["all_methods"]["kruskal_wallis"] = perMeasure([&](size_t m) { return toJson(report.all[m]); });
    json["comparisons"] = OrderedJson::array();
    for (const PairReport& pair : report.pairs) json["comparisons"].push_back(toJson(pair, false));
    return json;
}

}  // namespace

std::string evaluationJson(const Evaluation& evaluation, const EvaluationReport& report,
                           const SampleSettings* samples) {
    OrderedJson json{{"version", DRC_VERSION},
                     {"examples", evaluation.examples},
                     {"files", evaluation.files},
                     {"skipped_files", evaluation.skipped}};
    json["networks"] = OrderedJson::array();
    for (const EvaluatedNetwork& network : evaluation.networks)
        json["networks"].push_back({{"name", network.name},
                                    {"path", network.path},
                                    {"content", network.weights->hash()},
                                    {"metadata", network.weights->metadata()}});
    json["projections"] = OrderedJson::array();
    for (size_t g = 0; g < evaluation.groups.size(); ++g)
        json["projections"].push_back(toJson(evaluation.groups[g], report.groups[g]));
    if (samples) {
        for (size_t g = 0; g < evaluation.groups.size(); ++g)
            json["projections"][g]["samples"] = writeSamples(evaluation, g, *samples);
        json["samples"] = {{"seed", samples->seed}, {"error_scale", writeErrorScale(*samples)}};
    }
    json["across_projections"] = OrderedJson::array();
    for (const AcrossReport& across : report.across) {
        OrderedJson& entry = json["across_projections"].emplace_back();
        entry["first"] = evaluation.groups[across.first].name();
        entry["second"] = evaluation.groups[across.second].name();
        entry["viewpoints"] = across.viewpoints;
        for (const PairReport& pair : across.pairs) entry["comparisons"].push_back(toJson(pair, true));
    }
    // File names may be in any encoding.
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace drc
