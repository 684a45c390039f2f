#include <fmt/core.h>

#include <algorithm>

#include "app/evaluation_text.h"

namespace drc {
namespace {

constexpr int kCell = 12;

// Tables whose first column has the same width.
class Tables {
  public:
    explicit Tables(size_t nameWidth) : nameWidth_(nameWidth) {}

    template <typename F>
    void row(const std::string& name, const F& cell) {
        line(name);
        for (size_t m = 0; m < kMeasureCount; ++m) text_ += fmt::format("{:>{}}", cell(m), kCell);
        text_ += "\n";
    }
    void header(const std::string& name) {
        line("");
        for (size_t m = 0; m < kMeasureCount; m += 3)
            text_ +=
                fmt::format("{:>{}}", fmt::format("---------- {:^12} ---------", kMeasures[m].groupTitle), 3 * kCell);
        text_ += "\n";
        row(name, [](size_t m) { return std::string(kMeasures[m].title); });
    }
    void tests(const PairReport& pair) {
        row("  better in", [&](size_t m) { return fmt::format("{:.1f} %", 100 * pair.paired[m].better); });
        row("  Wilcoxon p", [&](size_t m) { return formatP(pair.paired[m].p); });
        row("  Kruskal-Wallis p", [&](size_t m) { return formatP(pair.kruskalWallis[m].p); });
    }
    void text(const std::string& text) { text_ += text; }
    const std::string& str() const { return text_; }

  private:
    void line(const std::string& name) { text_ += fmt::format("{:<{}}", name, nameWidth_); }

    size_t nameWidth_;
    std::string text_;
};

std::string fourDecimals(double x) { return fmt::format("{:.4f}", x); }

void addGroup(const GroupReport& group, Tables& tables) {
    const std::pair<const char*, double Summary::*> parts[] = {{"mean", &Summary::mean},
                                                               {"median", &Summary::median},
                                                               {"25 % below", &Summary::q1},
                                                               {"75 % below", &Summary::q3}};
    tables.header("");
    for (const auto& [title, part] : parts) {
        tables.text(std::string(title) + "\n");
        for (const MethodReport& method : group.methods)
            tables.row("  " + method.name, [&](size_t m) { return fourDecimals(method.summary[m].*part); });
    }
    tables.text("\nall methods\n");
    tables.row("  Kruskal-Wallis p", [&](size_t m) { return formatP(group.all[m].p); });
    for (const PairReport& pair : group.pairs) {
        tables.text(fmt::format("{} against {}\n", pair.first, pair.second));
        tables.tests(pair);
    }
}

void addAcross(const Evaluation& evaluation, const AcrossReport& across, Tables& tables) {
    const std::string first = evaluation.groups[across.first].name(), second = evaluation.groups[across.second].name();
    tables.text(fmt::format("\n{} against {}: {} viewpoints that both have\n\n", first, second, across.viewpoints));
    tables.header("");
    for (const PairReport& pair : across.pairs) {
        tables.text(pair.first == pair.second ? pair.first + "\n"
                                              : fmt::format("{} against {}\n", pair.first, pair.second));
        tables.row("  mean, " + first, [&](size_t m) { return fourDecimals(pair.firstMean[m]); });
        tables.row("  mean, " + second, [&](size_t m) { return fourDecimals(pair.secondMean[m]); });
        tables.tests(pair);
    }
}

}  // namespace

std::string describeGroup(const EvaluatedGroup& group) {
    int inputs = 1;
    for (const EvaluatedFile& file : group.files) inputs = std::max(inputs, file.inputs);
    return fmt::format("{} maps of {}x{} texels, {} examples of {} {}, {} each",
                       projectionName(group.layout.projection()), group.layout.size(), group.layout.size(),
                       group.examples.size(), group.files.size(), group.files.size() == 1 ? "file" : "files",
                       inputs == 1 ? "one input" : fmt::format("up to {} inputs", inputs));
}

std::string evaluationTable(const Evaluation& evaluation, const EvaluationReport& report) {
    size_t width = 20;
    for (const EvaluatedGroup& group : evaluation.groups) {
        width = std::max(width, group.name().size() + 10);
        for (const EvaluatedMethod& method : group.methods) width = std::max(width, method.name.size() + 4);
    }
    Tables tables(width);
    for (const EvaluatedNetwork& network : evaluation.networks)
        tables.text(fmt::format("{}: {}, content {}\n", network.name, network.path, network.weights->hash()));
    if (evaluation.skipped > 0)
        tables.text(fmt::format("{} {} skipped\n", evaluation.skipped, evaluation.skipped == 1 ? "file" : "files"));
    for (size_t g = 0; g < evaluation.groups.size(); ++g) {
        tables.text(fmt::format("{}{}\n\n", tables.str().empty() ? "" : "\n", describeGroup(evaluation.groups[g])));
        addGroup(report.groups[g], tables);
    }
    for (const AcrossReport& across : report.across) addAcross(evaluation, across, tables);
    return tables.str();
}

}  // namespace drc
