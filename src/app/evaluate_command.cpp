#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/command.h"
#include "app/models.h"
#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "cache/example_source.h"
#include "cache/map_evaluation.h"
#include "cache/network_enhancer.h"

namespace drc {
namespace {

using Json = nlohmann::ordered_json;

struct EvaluateOptions {
    std::vector<std::string> paths;
    std::string weights;
    int threads = 0;
    bool json = false, allInputs = false, quiet = false;
};

struct Method {
    std::unique_ptr<Enhancer> enhancer;
    std::vector<ExampleScores> scores;
};

struct Evaluation {
    std::vector<Method> methods;  // from the simplest on; each is compared with the one before it
    std::optional<MapLayout> layout;
    std::string weightsHash;
    size_t examples = 0;
    int files = 0, skipped = 0, inputs = 0;
};

// The table's columns.
struct Column {
    const char *group, *measure, *title;
    MapScores ExampleScores::*energy;
    double MapScores::*value;
    bool higherIsBetter;
};
constexpr Column kColumns[] = {
    {"as_rendered", "l1", "L1", &ExampleScores::asRendered, &MapScores::l1, false},
    {"as_rendered", "ssim", "SSIM", &ExampleScores::asRendered, &MapScores::ssim, true},
    {"as_rendered", "irradiance_relmse", "irradiance", &ExampleScores::asRendered, &MapScores::irradiance, false},
    {"equal_energy", "l1", "L1", &ExampleScores::equalEnergy, &MapScores::l1, false},
    {"equal_energy", "ssim", "SSIM", &ExampleScores::equalEnergy, &MapScores::ssim, true},
    {"equal_energy", "irradiance_relmse", "irradiance", &ExampleScores::equalEnergy, &MapScores::irradiance, false},
};

// Empty, with a note, if no weights were named and none are where they are looked for.
std::string weightsIfAny(const std::string& named) {
    try {
        return findWeights(named);
    } catch (const Error&) {
        logInfo("the network is left out: no weights were found; name them with --weights");
        return "";
    }
}

void makeMethods(const EvaluateOptions& options, const MapLayout& layout, Evaluation& result) {
    result.layout = layout;
    result.methods.push_back({makeIdentityEnhancer(), {}});
    result.methods.push_back({makeGaussianEnhancer(1), {}});
    const std::string path = weightsIfAny(options.weights);
    if (path.empty()) return;
    const auto weights = UNetWeights::load(path);
    try {
        result.methods.push_back({makeNetworkEnhancer(weights, layout), {}});
        result.weightsHash = weights->hash();
    } catch (const Error& error) {
        // The shipped weights are for one kind of map; examples may have another.
        if (!options.weights.empty()) throw;
        logInfo(std::string("the network is left out: ") + error.what() + "; name others with --weights");
    }
}

// Throws Error if the file cannot be part of the evaluation.
std::unique_ptr<ExampleSource> openFitting(const std::string& path, const std::optional<MapLayout>& layout) {
    auto examples = openExamples(path);
    if (examples->count() == 0) throw Error(SourceLocation{path}, "no examples in it");
    if (layout &&
        (layout->projection() != examples->layout().projection() || layout->size() != examples->layout().size()))
        throw Error(SourceLocation{path}, "its maps have another projection or size than those of the files before it");
    return examples;
}

Evaluation evaluate(const EvaluateOptions& options) {
    const std::vector<std::string> paths = findExamples(options.paths);
    Progress progress("files", int64_t(paths.size()), options.quiet ? ProgressMode::Quiet : ProgressMode::Auto);
    Evaluation result;
    for (const std::string& path : paths) {
        progress.add();
        std::unique_ptr<ExampleSource> examples;
        try {
            examples = openFitting(path, result.layout);
        } catch (const Error& e) {
            logWarning(std::string(e.what()) + "; skipped");
            ++result.skipped;
            continue;
        }
        if (!result.layout) makeMethods(options, examples->layout(), result);
        const int inputs = options.allInputs ? examples->inputs() : 1;
        for (Method& method : result.methods) {
            const auto scores = evaluateEnhancer(*examples, *method.enhancer, inputs);
            method.scores.insert(method.scores.end(), scores.begin(), scores.end());
        }
        result.examples += size_t(examples->count());
        result.inputs = std::max(result.inputs, inputs);
        ++result.files;
    }
    progress.finish();
    if (result.examples == 0) throw Error("no examples to evaluate; `drc reference` writes them");
    return result;
}

std::vector<double> column(const Method& method, const Column& c) {
    std::vector<double> values;
    for (const ExampleScores& s : method.scores) values.push_back((s.*c.energy).*c.value);
    return values;
}

double mean(const Method& method, const Column& c) {
    double sum = 0;
    for (const double v : column(method, c)) sum += v;
    return sum / double(method.scores.size());
}

// How often, and how surely, `a` is better than `b`.
PairedComparison compareMethods(const Method& a, const Method& b, const Column& c) {
    return c.higherIsBetter ? compareSmaller(column(b, c), column(a, c)) : compareSmaller(column(a, c), column(b, c));
}

// JSON has no NaN: it becomes null.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

std::string toJson(const Evaluation& e) {
    Json json;
    json["examples"] = e.examples;
    json["files"] = e.files;
    json["skipped_files"] = e.skipped;
    json["projection"] = projectionName(e.layout->projection());
    json["map_size"] = e.layout->size();
    json["inputs"] = e.inputs;
    json["weights"] = e.weightsHash.empty() ? Json(nullptr) : Json(e.weightsHash);
    for (const Method& method : e.methods)
        for (const Column& c : kColumns)
            json["methods"][method.enhancer->name()][c.group][c.measure] = number(mean(method, c));
    json["comparisons"] = Json::array();
    for (size_t i = 1; i < e.methods.size(); ++i) {
        Json pair;
        pair["first"] = e.methods[i].enhancer->name();
        pair["second"] = e.methods[i - 1].enhancer->name();
        for (const Column& c : kColumns) {
            const PairedComparison result = compareMethods(e.methods[i], e.methods[i - 1], c);
            pair[c.group][c.measure] = {{"p", number(result.p)}, {"first_better", number(result.better)}};
        }
        json["comparisons"].push_back(pair);
    }
    return json.dump() + "\n";
}

// Beyond the range of numbers p is not nought.
std::string pValue(double p) { return p < 1e-300 ? "< 1e-300" : fmt::format("{:.2g}", p); }

// A row of the table: a name and a cell a column.
template <typename F>
std::string row(const std::string& name, F&& cell) {
    std::string line = fmt::format("{:<20}", name);
    for (const Column& c : kColumns) line += fmt::format("{:>12}", cell(c));
    return line + "\n";
}

std::string toTable(const Evaluation& e) {
    std::string table =
        fmt::format("{} examples of {} files ({} skipped), {} maps of {}x{} texels, {} each\n\n", e.examples, e.files,
                    e.skipped, projectionName(e.layout->projection()), e.layout->size(), e.layout->size(),
                    e.inputs == 1 ? "one input" : fmt::format("up to {} inputs", e.inputs));
    table +=
        fmt::format("{:<20}{:>36}{:>36}\n", "", "--------- as rendered ---------", "--------- equal energy --------");
    table += row("mean", [](const Column& c) { return std::string(c.title); });
    for (const Method& method : e.methods)
        table += row(method.enhancer->name(), [&](const Column& c) { return fmt::format("{:.4f}", mean(method, c)); });
    for (size_t i = 1; i < e.methods.size(); ++i) {
        const Method &a = e.methods[i], &b = e.methods[i - 1];
        table += fmt::format("\n{} against {}\n", a.enhancer->name(), b.enhancer->name());
        table += row("  better in",
                     [&](const Column& c) { return fmt::format("{:.1f} %", 100 * compareMethods(a, b, c).better); });
        table += row("  p", [&](const Column& c) { return pValue(compareMethods(a, b, c).p); });
    }
    return table;
}

void run(const EvaluateOptions& options) {
    setThreadCount(options.threads);
    if (options.quiet) setLogLevel(LogLevel::Quiet);
    const Evaluation evaluation = evaluate(options);
    fmt::print("{}", options.json ? toJson(evaluation) : toTable(evaluation));
}

}  // namespace

void addEvaluateCommand(CLI::App& app) {
    auto* command = app.add_subcommand("evaluate", "Measure how close enhanced maps come to converged ones");
    auto o = std::make_shared<EvaluateOptions>();
    command->add_option("EXAMPLES", o->paths, "What `drc reference` writes: files, or folders of them")->required();
    command->add_option("--weights", o->weights, "Weights of the network, safetensors. Default: the shipped ones");
    command->add_flag("--all-inputs", o->allInputs,
                      "Average over every realisation of an example, not the first alone");
    command->add_flag("--json", o->json, "Print one JSON object");
    command->add_option("--nthreads", o->threads, "Threads; 0: one a core")->capture_default_str();
    command->add_flag("--quiet", o->quiet, "Say nothing but errors, warnings and the result");
    command->footer(
        "Methods: none, gaussian (sigma 1) and network, each as the renderer runs it. Measures of a map and its "
        "target,\n"
        "both divided by the target's mean (as rendered), or each by its own (equal energy):\n"
        "  L1          mean absolute difference over the hemisphere\n"
        "  SSIM        of the luminances, exposed so that the target's 99th percentile is white, clipped above,\n"
        "              sRGB-encoded; window of 11 x 11 texels; 1 is equal\n"
        "  irradiance  relative squared error of the irradiance, mean over 64 normals in the hemisphere\n"
        "p: Wilcoxon's signed-rank test over examples, two-sided, normal approximation. It takes examples as "
        "independent;\n"
        "those of one scene are less so.\n\n"
        "Example: drc evaluate examples/held-out --weights models/drc.safetensors");
    command->callback([o] { run(*o); });
}

}  // namespace drc
