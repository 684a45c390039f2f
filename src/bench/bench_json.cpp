#include "bench/bench_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace drc {
namespace {

using Json = nlohmann::ordered_json;

struct Quantity {
    const char* name;
    double BenchRun::*value;
};
constexpr Quantity kQuantities[] = {{"seconds", &BenchRun::seconds},
                                    {"load_seconds", &BenchRun::loadSeconds},
                                    {"render_seconds", &BenchRun::renderSeconds},
                                    {"denoise_seconds", &BenchRun::denoiseSeconds},
                                    {"write_seconds", &BenchRun::writeSeconds},
                                    {"cpu_seconds", &BenchRun::cpuSeconds},
                                    {"peak_mb", &BenchRun::peakMegabytes},
                                    {"spp", &BenchRun::spp},
                                    {"error", &BenchRun::error},
                                    {"error_se", &BenchRun::errorSe},
                                    {"trimmed_error", &BenchRun::trimmedError},
                                    {"trimmed_error_se", &BenchRun::trimmedErrorSe},
                                    {"block_error", &BenchRun::blockError},
                                    {"block_error_se", &BenchRun::blockErrorSe},
                                    {"ssim", &BenchRun::ssim},
                                    {"flip", &BenchRun::flip},
                                    {"png_kb", &BenchRun::pngKb},
                                    {"entropy", &BenchRun::entropy}};

struct UnitName {
    const char* name;
    BudgetUnit unit;
};
constexpr UnitName kUnits[] = {
    {"seconds", BudgetUnit::Seconds}, {"spp", BudgetUnit::Spp}, {"tasks", BudgetUnit::Tasks}};

// JSON has no NaN.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
double number(const Json& json) { return json.is_null() ? kNotMeasured : json.get<double>(); }

Json budgetJson(const Budget& budget) {
    for (const UnitName& unit : kUnits)
        if (unit.unit == budget.unit) return {{"unit", unit.name}, {"amount", budget.amount}};
    return nullptr;
}

Budget budgetFrom(const Json& json) {
    const std::string name = json.at("unit");
    for (const UnitName& unit : kUnits)
        if (name == unit.name) return {unit.unit, json.at("amount")};
    throw std::invalid_argument("no such unit");
}

Json runJson(const BenchRun& run) {
    Json json{{"scene", run.scene}, {"method", run.method}, {"budget", budgetJson(run.budget)}, {"repeat", run.repeat}};
    if (!run.failure.empty()) {
        json["failure"] = run.failure;
        return json;
    }
    json["picture"] = run.picture;
    if (!run.oidnMode.empty()) json["oidn_mode"] = run.oidnMode;
    for (const Quantity& quantity : kQuantities) json[quantity.name] = number(run.*quantity.value);
    json["mean_ratio"] = {number(run.meanRatio[0]), number(run.meanRatio[1]), number(run.meanRatio[2])};
    return json;
}

BenchRun runFrom(const Json& json) {
    BenchRun run;
    run.scene = json.at("scene");
    run.method = json.at("method");
    run.budget = budgetFrom(json.at("budget"));
    run.repeat = json.at("repeat");
    run.failure = json.value("failure", "");
    if (!run.failure.empty()) return run;
    run.picture = json.at("picture");
    run.oidnMode = json.value("oidn_mode", "");
    for (const Quantity& quantity : kQuantities) run.*quantity.value = number(json.at(quantity.name));
    for (size_t c = 0; c < 3; ++c) run.meanRatio[c] = number(json.at("mean_ratio").at(c));
    return run;
}

Json spreadJson(const BenchReport& report, const BenchScene& scene, const std::string& method, const Budget& budget) {
    const auto runs = runsOf(report, scene.name, method, budget);
    if (runs.empty()) return nullptr;
    Json json{{"scene", scene.name}, {"method", method}, {"budget", budgetJson(budget)}, {"count", runs.size()}};
    for (const Quantity& quantity : kQuantities) {
        std::vector<double> values;
        for (const BenchRun* run : runs) values.push_back(run->*quantity.value);
        const BenchSpread spread = spreadOf(values);
        json[quantity.name] = {
            {"median", number(spread.median)}, {"low", number(spread.low)}, {"high", number(spread.high)}};
    }
    const double opponent = opponentError(report, scene.name, budget);
    json["error_by_path_oidn"] =
        number(json["error"]["median"].is_null() ? kNotMeasured : json["error"]["median"].get<double>() / opponent);
    return json;
}

}  // namespace

std::string toJson(const BenchReport& report) {
    Json json{{"format", "drc-bench-2"},   {"version", report.version}, {"processor", report.processor},
              {"threads", report.threads}, {"methods", report.methods}, {"scenes", Json::array()},
              {"runs", Json::array()},     {"summary", Json::array()}};
    for (const BenchScene& scene : report.scenes)
        json["scenes"].push_back({{"name", scene.name},
                                  {"file", scene.file},
                                  {"width", scene.width},
                                  {"height", scene.height},
                                  {"reference", scene.reference},
                                  {"reference_pair", scene.pair},
                                  {"reference_noise", number(scene.referenceNoise)},
                                  {"ssim_noise", number(scene.ssimNoise)},
                                  {"flip_noise", number(scene.flipNoise)},
                                  {"reference_origin", scene.referenceOrigin},
                                  {"reference_png_kb", number(scene.referencePngKb)},
                                  {"reference_entropy", number(scene.referenceEntropy)}});
    for (const BenchRun& run : report.runs) json["runs"].push_back(runJson(run));
    for (const BenchScene& scene : report.scenes)
        for (const Budget& budget : report.budgets)
            for (const std::string& method : report.methods)
                if (Json spread = spreadJson(report, scene, method, budget); !spread.is_null())
                    json["summary"].push_back(std::move(spread));
    return json.dump(1) + "\n";
}

std::string toJson(const BenchRun& run, const std::string& key) {
    Json json = runJson(run);
    json["key"] = key;
    json["measured_against"] = run.measuredAgainst;
    return json.dump(1) + "\n";
}

std::optional<BenchRun> runFromJson(const std::string& text, const std::string& key) {
    try {
        const Json json = Json::parse(text);
        if (json.at("key") != key) return {};
        BenchRun run = runFrom(json);
        run.measuredAgainst = json.at("measured_against");
        return run;
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace drc
