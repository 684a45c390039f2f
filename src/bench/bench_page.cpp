#include "bench/bench_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "bench/page_curves.h"
#include "bench/page_equal_time.h"
#include "bench/page_measures.h"
#include "bench/page_paper_table.h"
#include "bench/page_pictures.h"
#include "bench/page_viewer.h"
#include "report/html_page.h"

namespace drc {
namespace {

struct Section {
    const char *id, *title, *note;  // note: HTML
    std::string body;
};

constexpr const char* kEqualTimeNote =
    "<p class=\"note\">Every method had the same seconds for all that its process does, reading and writing included. "
    "Medians of the repeats; in small type the standard error of one run and the interval that holds the true median "
    "with 95&#8201;%, or, of fewer than six repeats, all of them. Bold: the best of its scene, if it is better than "
    "all "
    "others by more than the standard errors of both together, and the intervals of repeats do not overlap. Arrows "
    "point to where better is. ~: more than a quarter of it is the references\u2019 own noise. load to write: seconds, "
    "where the "
    "program tells; seconds: of the whole process.</p>\n";
constexpr const char* kPaperNote =
    "<p class=\"note\">The rows of the paper\u2019s table, in the units of each method. In the paper SSIM was 0.89 at "
    "16 tasks and went no higher than 0.91; bidirectional path tracing had 0.82 in the same time and 0.90 in four "
    "times the time. Its scene and machine are not these: compare the behaviour, not the numbers. SSIM between two "
    "runs is taken as linear in the logarithm of time; a dash is outside of what was run.</p>\n";
constexpr const char* kCurvesNote =
    "<p class=\"note\">Lower and further left is better. Both axes are logarithmic; seconds are those of the whole "
    "process. Discs: given seconds; squares: given samples a pixel; diamonds: given tasks. Bars are the intervals of "
    "the repeats.</p>\n";
constexpr const char* kMemoryNote =
    "<p class=\"note\">Largest resident memory of the process. Maps of earlier passes are not kept, so the line should "
    "be flat.</p>\n";
constexpr const char* kFiguresNote =
    "<p class=\"note\">Below each picture its difference to the reference, between displayed colours and four times as "
    "large. Numbers are those of the picture shown, the first repeat.</p>\n";

constexpr const char* kTableStyle = R"(
.equal-time { table-layout: fixed; width: 97rem; }
.equal-time thead th { width: 5rem; } .equal-time thead th.interval { width: 9rem; }
.equal-time thead th:first-child { width: 11rem; } .equal-time .name { white-space: normal; overflow-wrap: anywhere; }
@media (max-width: 40rem) { .equal-time { width: 92rem; } .equal-time thead th:first-child { width: 6rem; } }
)";

std::string paragraph(const std::string& style, const std::string& html) {
    return fmt::format("<p class=\"{}\">{}</p>\n", style, html);
}

std::string counted(size_t count, const std::string& what) {
    return fmt::format("{}&#160;{}{}", count, what, count == 1 ? "" : "s");
}

std::string header(const BenchReport& report, const std::vector<Section>& sections) {
    const auto failed =
        std::count_if(report.runs.begin(), report.runs.end(), [](const BenchRun& run) { return !run.failure.empty(); });
    std::string html =
        "<h1>Methods of rendering, compared</h1>\n" +
        paragraph("lead", fmt::format("{}, {}, {}{}. By drc {} on {}, {}.", counted(report.scenes.size(), "scene"),
                                      counted(report.methods.size(), "method"), counted(report.runs.size(), "run"),
                                      failed == 0 ? "" : fmt::format(", of which {} failed", failed),
                                      escapeHtml(report.version), escapeHtml(report.processor),
                                      counted(size_t(std::max(0, report.threads)), "thread"))) +
        "<p class=\"contents\">";
    for (const Section& section : sections) html += fmt::format("<a href=\"#{}\">{}</a> ", section.id, section.title);
    return html + "</p>\n";
}

std::string pictureSection(const BenchReport& report, const PagePictures& pictures) {
    if (pictures.empty()) return "";
    std::string html = viewer(report);
    if (!pictures.figures.empty())
        html +=
            "<noscript><p class=\"note\">More pictures are under <a href=\"#figures\">Figures</a>.</p></noscript>\n";
    // Open for those whose browser runs no scripts; the viewer's script closes it.
    if (!pictures.gallery.empty())
        html +=
            "<details class=\"all\" open=\"open\"><summary>All pictures that are not among the figures</summary>\n" +
            pictures.gallery + "</details>\n";
    return html;
}

// "3", or "1 to 3" where runs differ.
std::string repeats(const BenchReport& report) {
    std::map<std::tuple<std::string, std::string, int, double>, int> counts;
    for (const BenchRun& run : report.runs) ++counts[{run.scene, run.method, int(run.budget.unit), run.budget.amount}];
    if (counts.empty()) return "0";
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end(),
                                                   [](const auto& a, const auto& b) { return a.second < b.second; });
    return least->second == most->second ? fmt::format("{}", most->second)
                                         : fmt::format("{} to {}", least->second, most->second);
}

std::string factRow(const std::string& name, const std::string& html) {
    return fmt::format("<tr><td class=\"name soft\">{}</td><td class=\"text\">{}</td></tr>\n", name, html);
}

std::string joined(const auto& items, const auto& name) {
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "" : ", ") + name(item);
    return escapeHtml(text);
}

// "10, 30 s; 1, 2, 4 tasks".
std::string budgets(const BenchReport& report) {
    std::string text;
    for (const BudgetUnit unit : {BudgetUnit::Seconds, BudgetUnit::Spp, BudgetUnit::Tasks}) {
        const std::vector<Budget> ofUnit = budgetsOf(report, unit);
        for (const Budget& budget : ofUnit) {
            const char* separator = text.empty() ? "" : budget == ofUnit.front() ? "; " : ", ";
            text += separator + (budget == ofUnit.back() ? budgetName(budget) : fmt::format("{:g}", budget.amount));
        }
    }
    return text;
}

std::string howItWasMade(const BenchReport& report) {
    std::string scenes;
    for (const BenchScene& scene : report.scenes)
        scenes += fmt::format(
            "<tr><td class=\"name\">{}</td><td class=\"text\"><code>{}</code></td><td>{}&#8201;&#215;&#8201;{}</td>"
            "<td class=\"text\">{}</td><td>{}</td></tr>\n",
            escapeHtml(scene.name), escapeHtml(scene.file), scene.width, scene.height,
            (scene.pair.empty() ? "one, " : "two, ") + escapeHtml(scene.referenceOrigin),
            htmlSignificant(scene.referenceNoise));
    return "<div class=\"wide\"><table>\n<tbody>\n" + factRow("program", "drc " + escapeHtml(report.version)) +
           factRow("processor", escapeHtml(report.processor)) + factRow("threads", std::to_string(report.threads)) +
           factRow("methods", joined(report.methods, [](const std::string& name) { return name; })) +
           factRow("budgets", budgets(report)) + factRow("repeats", repeats(report)) +
           "</tbody>\n</table></div>\n<div class=\"wide\"><table>\n<thead><tr><th class=\"name\">scene</th><th "
           "class=\"name\">file</th><th>pixels</th><th class=\"name\">references</th><th>their "
           "noise</th></tr></thead>\n<tbody>\n" +
           scenes +
           "</tbody>\n</table></div>\n<p class=\"note\"><b>SSIM</b>: structural similarity of the displayed "
           "luminances. <b>FLIP</b>: the difference that is seen when two pictures alternate. <b>error</b>: mean of "
           "(T&#160;&#8722;&#160;R<sub>1</sub>)(T&#160;&#8722;&#160;R<sub>2</sub>)&#8201;/&#8201;"
           "(D<sup>2</sup>&#160;+&#160;0.01), D the radiance about the pixel: the squared relative error without the "
           "references\u2019 noise. <b>trimmed</b>: without the 0.1&#8201;% of pixels that stand out most. "
           "<b>blocks</b>: of means of 8&#215;8 pixels. With one reference only, error and blocks are relMSE, the "
           "reference\u2019s noise in them. "
           "<b>seconds</b>: wall clock of the whole process. <b>CPU&#8201;s</b>: of all its threads and children. "
           "<b>peak MB</b>: its largest resident memory, in units of 10<sup>6</sup> bytes. <b>PNG KB</b>: size of the "
           "8-bit picture in units of 1000 bytes; noise does not compress. <b>entropy</b>: of the 256 levels of its "
           "luminance, in bits a pixel.</p>\n";
}

}  // namespace

std::string benchPage(const BenchReport& report, const std::string& folder) {
    const PagePictures pictures = pagePictures(report, folder);
    std::vector<Section> sections{
        {"equal-time", "Equal time", kEqualTimeNote, equalTimeTables(report)},
        {"pictures", "Pictures", "", pictureSection(report, pictures)},
        {"tasks-and-samples", "Tasks and samples", kPaperNote, paperTables(report)},
        {"curves", "Error against time", kCurvesNote, errorCurves(report)},
        {"memory", "Memory against tasks", kMemoryNote, memoryCurves(report)},
        {"figures", "Figures", kFiguresNote, pictures.figures},
        {"made", "How it was made", "", howItWasMade(report)},
    };
    std::erase_if(sections, [](const Section& section) { return section.body.empty(); });
    std::string body = header(report, sections);
    for (const Section& section : sections)
        body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}{}</section>\n", section.id, section.title,
                            section.note, section.body);
    if (!pictures.empty()) body += viewerScript();
    return htmlPage("Methods of rendering, compared", body, kTableStyle + pictureStyle());
}

}  // namespace drc
