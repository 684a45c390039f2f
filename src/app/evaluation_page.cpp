#include "app/evaluation_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/evaluation_page_tables.h"
#include "app/evaluation_samples.h"
#include "app/evaluation_text.h"
#include "report/html_page.h"
#include "report/svg_box_plot.h"

namespace drc {
namespace {

constexpr int kColours = 8;
// The most important metadata of a network come first; the rest is folded.
constexpr const char* kMainKeys[] = {"projection", "ablation", "data", "examples_drawn", "validation", "commit"};

std::string heading(int level, const std::string& text) {
    return fmt::format("<h{0}>{1}</h{0}>\n", level, escapeHtml(text));
}

// Irradiance errors span decades, so their axis is logarithmic.
bool isLogarithmic(const Measure& measure) { return measure.value == &MapScores::irradiance; }

// All groups share one axis for each measure, so that they can be compared by eye.
PerMeasure<PlotAxis> makeAxes(const EvaluationReport& report) {
    PerMeasure<PlotAxis> axes;
    for (size_t m = 0; m < kMeasureCount; ++m) {
        std::vector<Summary> all;
        for (const GroupReport& group : report.groups)
            for (const MethodReport& method : group.methods) all.push_back(method.summary[m]);
        axes[m] = axisFor(all, isLogarithmic(kMeasures[m]));
    }
    return axes;
}

std::string plots(const Evaluation& evaluation, const GroupReport& group, const PerMeasure<PlotAxis>& axes) {
    std::string html = "<div class=\"plots\">\n";
    for (size_t m = 0; m < kMeasureCount; ++m) {
        std::vector<BoxPlotRow> rows;
        for (const MethodReport& method : group.methods) {
            // A network has the same colour in all groups.
            const auto found = std::find_if(evaluation.networks.begin(), evaluation.networks.end(),
                                            [&](const EvaluatedNetwork& n) { return n.name == method.name; });
            const auto network = found - evaluation.networks.begin();
            const int colour =
                found != evaluation.networks.end() ? 2 + int(network) % (kColours - 2) : int(rows.size());
            rows.push_back({method.name, method.summary[m], colour});
        }
        html += boxPlotSvg(fmt::format("{}, {}{}", kMeasures[m].title, kMeasures[m].groupTitle,
                                       axes[m].logarithmic ? ", logarithmic" : ""),
                           rows, axes[m]);
    }
    return html + "</div>\n";
}

std::string spaced(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

// One row for each key that any network has, one column for each network; keys in the given order.
std::string metadataRows(const std::vector<EvaluatedNetwork>& networks, const std::vector<std::string>& keys) {
    std::string html;
    for (const std::string& key : keys) {
        std::string cells;
        bool any = false;
        for (const EvaluatedNetwork& network : networks) {
            const StringMap& metadata = network.weights->metadata();
            const auto found = metadata.find(key);
            any = any || found != metadata.end();
            cells +=
                fmt::format("<td class=\"text\">{}</td>", found == metadata.end() ? "" : escapeHtml(found->second));
        }
        if (any) html += fmt::format("<tr><td class=\"name soft\">{}</td>{}</tr>\n", escapeHtml(spaced(key)), cells);
    }
    return html;
}

std::string networkTables(const std::vector<EvaluatedNetwork>& networks) {
    std::string head = "<thead><tr><th class=\"name\"></th>", files = "<tr><td class=\"name soft\">file</td>",
                contents = "<tr><td class=\"name soft\">content</td>";
    std::set<std::string> others;
    for (const EvaluatedNetwork& network : networks) {
        head += fmt::format("<th class=\"name\">{}</th>", escapeHtml(network.name));
        files += fmt::format("<td class=\"text\">{}</td>", escapeHtml(network.path));
        contents += fmt::format("<td class=\"text\">{}</td>", escapeHtml(network.weights->hash()));
        for (const auto& [key, value] : network.weights->metadata()) others.insert(key);
    }
    head += "</tr></thead>\n";
    for (const char* key : kMainKeys) others.erase(key);
    const auto table = [&](const std::string& rows) {
        return "<div class=\"wide\"><table>\n" + head + "<tbody>\n" + rows + "</tbody>\n</table></div>\n";
    };
    return table(files + "</tr>\n" + contents + "</tr>\n" +
                 metadataRows(networks, {std::begin(kMainKeys), std::end(kMainKeys)})) +
           "<details><summary>The rest of their metadata</summary>\n" +
           table(metadataRows(networks, {others.begin(), others.end()})) + "</details>\n";
}

std::string fileTable(const Evaluation& evaluation) {
    std::string html =
        "<details><summary>Files of examples</summary>\n<div class=\"wide\"><table>\n<thead><tr><th "
        "class=\"name\">file</th>"
        "<th class=\"name\">scene</th><th "
        "class=\"name\">maps</th><th>examples</th><th>inputs</th></tr></thead>\n<tbody>\n";
    for (const EvaluatedGroup& group : evaluation.groups)
        for (const EvaluatedFile& file : group.files)
            html += fmt::format(
                "<tr><td class=\"name\">{}</td><td class=\"name\">{}</td><td "
                "class=\"name\">{}</td><td>{}</td><td>{}</td></tr>\n",
                escapeHtml(file.source->path()), escapeHtml(file.source->scene()), escapeHtml(group.name()),
                file.source->count(), file.inputs);
    return html + "</tbody>\n</table></div></details>\n";
}

std::string header(const Evaluation& evaluation) {
    std::string html = heading(1, "Denoised radiance maps against converged ones");
    html += fmt::format("<p class=\"lead\">{} examples of {} {}{}, by drc {}.</p>\n", evaluation.examples,
                        evaluation.files, evaluation.files == 1 ? "file" : "files",
                        evaluation.skipped > 0 ? fmt::format(" ({} skipped)", evaluation.skipped) : "", DRC_VERSION);
    html +=
        "<p>An example is a map captured with one sample a texel and the same map with many, the reference. "
        "<em>none</em> leaves the captured map as it is, <em>gaussian</em> blurs it by one texel, a network predicts "
        "it; "
        "each as the renderer runs it.</p>\n"
        "<p class=\"note\"><b>As rendered</b>: map and reference are divided by the reference\u2019s mean. "
        "<b>Equal energy</b>: each by its own. <b>L1</b>: mean absolute difference over the hemisphere. <b>SSIM</b>: "
        "structural similarity of the luminances, exposed so that the reference\u2019s 99th percentile is white. "
        "<b>Irradiance</b>: relative squared error of the irradiance, mean over 64 normals. Arrows point to where "
        "better "
        "is.</p>\n";
    if (!evaluation.networks.empty()) html += heading(3, "Networks") + networkTables(evaluation.networks);
    return html + fileTable(evaluation);
}

// At the head of a section.
std::string capitalised(std::string name) {
    name[0] = char(std::toupper(name[0]));
    return name;
}

std::string acrossSection(const Evaluation& evaluation, const AcrossReport& across) {
    const std::string first = evaluation.groups[across.first].name(), second = evaluation.groups[across.second].name();
    return heading(2, capitalised(first) + " against " + second) +
           fmt::format(
               "<p class=\"note\">{} viewpoints that both have, in pairs. \u201cBetter in\u201d: share of them in "
               "which {} is. "
               "L1 and irradiance are means over the hemisphere and compare directly; SSIM is taken between pictures, "
               "which each projection stretches in its own way: of it only large differences mean something.</p>\n",
               across.viewpoints, escapeHtml(first)) +
           acrossTable(across, first, second);
}

std::string groupSection(const Evaluation& evaluation, const EvaluationReport& report, size_t g,
                         const PerMeasure<PlotAxis>& axes) {
    const EvaluatedGroup& group = evaluation.groups[g];
    return heading(2, capitalised(group.name()) + " maps") +
           fmt::format("<p class=\"lead\">{}.</p>\n", escapeHtml(describeGroup(group))) + scoreTable(report.groups[g]) +
           "<p class=\"note\">Bold: the best of its block. Quartiles: a quarter of the examples lies below the first, "
           "a "
           "quarter above the second.</p>\n" +
           heading(3, "Distribution over examples") + plots(evaluation, report.groups[g], axes) +
           "<p class=\"note\">Boxes from quartile to quartile, a line at the median, a circle at the mean; whiskers "
           "from the "
           "5th to the 95th percentile." +
           (report.groups.size() > 1 ? " All projections have the same axes.</p>\n" : "</p>\n") +
           heading(3, "Is the difference chance?") + testTable(report.groups[g]) +
           "<p class=\"note\">\u201cBetter in\u201d: share of the examples in which the first method is. Wilcoxon: "
           "signed ranks of "
           "the pairs, two-sided, normal approximation. Kruskal\u2013Wallis: ranks of all scores, as if no two were of "
           "one "
           "example, corrected for ties, by the chi-square distribution. Both take examples as independent; those of "
           "one "
           "scene are less so.</p>\n";
}

std::string sampleSection(const EvaluatedGroup& group, const PageSamples& samples) {
    const std::vector<size_t> chosen = chooseExamples(group, samples.count, samples.seed);
    if (chosen.empty()) return "";
    return heading(2, "Examples of " + group.name() + " maps") +
           fmt::format(
               "<p class=\"note\">{} of {} examples, chosen at random (seed {}), the first input of each. Upper row: "
               "distance "
               "(near is dark, far is bright, logarithmic; blue where nothing was hit) and radiance, all of an example "
               "under one exposure, in which the reference\u2019s 99th percentile is white. Lower row: normals (x, y, "
               "z in "
               "the map\u2019s frame as red, green, blue) and the error against the reference in false colour. The "
               "scale of an example\u2019s errors is the same for all methods; it ends where one texel in twenty is "
               "worse, "
               "the captured map not counted. Scores are those as rendered.</p>\n",
               chosen.size(), group.examples.size(), samples.seed) +
           sampleMaps(group, chosen);
}

}  // namespace

std::string evaluationPage(const Evaluation& evaluation, const EvaluationReport& report, const PageSamples& samples) {
    const PerMeasure<PlotAxis> axes = makeAxes(report);
    std::string body = header(evaluation);
    for (size_t g = 0; g < evaluation.groups.size(); ++g) body += groupSection(evaluation, report, g, axes);
    for (const AcrossReport& across : report.across) body += acrossSection(evaluation, across);
    for (const EvaluatedGroup& group : evaluation.groups) body += sampleSection(group, samples);
    return htmlPage("Radiance maps, evaluated", body);
}

}  // namespace drc
