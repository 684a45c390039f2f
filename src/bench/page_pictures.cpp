#include "bench/page_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/error.h"
#include "bench/page_measures.h"
#include "image/difference_image.h"
#include "image/image_io.h"
#include "report/html_page.h"

namespace drc {
namespace {

const BenchMeasure* const kCaption[] = {&kError, &kBlockError, &kSsim, &kFlip, &kSeconds};

std::string pathIn(const std::string& folder, const std::string& file) {
    return (std::filesystem::path(folder) / file).string();
}

// The first repeat with a picture; null if there is none.
const BenchRun* shownRun(const BenchReport& report, const std::string& scene, const std::string& method,
                         const Budget& budget) {
    const BenchRun* shown = nullptr;
    for (const BenchRun* run : runsOf(report, scene, method, budget))
        if (!run->picture.empty() && (!shown || run->repeat < shown->repeat)) shown = run;
    return shown;
}

std::string figure(const std::string& place, const std::string& name, const std::string& alt, const Image& picture,
                   const std::string& difference, const std::string& facts) {
    return fmt::format(
        "<figure {}><figcaption>{}</figcaption><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"/>{}<dl>{}</dl>"
        "</figure>\n",
        place, name, pngDataUri(picture), picture.width(), picture.height(), escapeHtml(alt), difference, facts);
}

std::string fact(const std::string& name, const std::string& value) {
    return "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>";
}

std::string differenceTo(const Image& reference, const Image& picture, const std::string& path) {
    try {
        const int width = picture.width(), height = picture.height();
        const Image colours = differenceImage(reference, picture).crop(2 * width, 0, 3 * width, height);
        return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"its difference to the reference\"/>",
                           pngDataUri(colours), width, height);
    } catch (const Error& error) {
        throw Error(fmt::format("cannot show {}: {}", path, error.what()));
    }
}

class ScenePictures {
  public:
    ScenePictures(const BenchReport& report, const std::string& folder, size_t scene)
        : report_(report), folder_(folder), index_(scene), scene_(report.scenes[scene]) {
        if (any()) reference_ = readLinearRgb(pathIn(folder, scene_.reference));
    }

    bool any() const {
        for (size_t b = 0; b < report_.budgets.size(); ++b)
            if (methodsWith(b) > 0) return true;
        return false;
    }

    // The budget of the figures; none if no budget has pictures of two methods.
    std::optional<size_t> commonBudget() const {
        std::optional<size_t> chosen;
        const auto rank = [&](size_t b) {
            const Budget& budget = report_.budgets[b];
            return std::tuple(methodsWith(b), -int(budget.unit), budget.amount);
        };
        for (size_t b = 0; b < report_.budgets.size(); ++b)
            if (methodsWith(b) > 1 && (!chosen || rank(b) > rank(*chosen))) chosen = b;
        return chosen;
    }

    std::string strip(size_t budget) const {
        std::string html = referenceFigure();
        for (size_t m = 0; m < report_.methods.size(); ++m) html += methodFigure(m, budget, true);
        return html;
    }

    std::string rest(std::optional<size_t> stripBudget) const {
        std::string html = stripBudget ? "" : referenceFigure();
        for (size_t m = 0; m < report_.methods.size(); ++m)
            for (size_t b = 0; b < report_.budgets.size(); ++b)
                if (b != stripBudget) html += methodFigure(m, b, false);
        return html;
    }

  private:
    int methodsWith(size_t budget) const {
        return int(std::count_if(report_.methods.begin(), report_.methods.end(), [&](const std::string& method) {
            return shownRun(report_, scene_.name, method, report_.budgets[budget]) != nullptr;
        }));
    }

    std::string referenceFigure() const {
        return figure(
            fmt::format("data-scene=\"{}\" data-method=\"reference\"", index_), "<b>reference</b>",
            "the reference of " + scene_.name, reference_, "",
            fact("PNG KB", oneDecimal(scene_.referencePngKb)) + fact("entropy", twoDecimals(scene_.referenceEntropy)));
    }

    std::string methodFigure(size_t method, size_t budget, bool withDifference) const {
        const std::string& name = report_.methods[method];
        const BenchRun* run = shownRun(report_, scene_.name, name, report_.budgets[budget]);
        if (!run) return "";
        const std::string path = pathIn(folder_, run->picture);
        const Image picture = readLinearRgb(path);
        std::string facts;
        for (const BenchMeasure* measure : kCaption)
            facts += fact(measure->title, measure->text(run->*(measure->value)));
        const std::string spent = budgetName(report_.budgets[budget]);
        return figure(fmt::format("data-scene=\"{}\" data-method=\"{}\" data-budget=\"{}\"", index_, method, budget),
                      "<b>" + escapeHtml(name) + "</b> " + (withDifference ? "" : spent),
                      fmt::format("{} by {}, {}", scene_.name, name, spent), picture,
                      withDifference ? differenceTo(reference_, picture, path) : "", facts);
    }

    const BenchReport& report_;
    const std::string& folder_;
    size_t index_;
    const BenchScene& scene_;
    Image reference_;
};

}  // namespace

PagePictures pagePictures(const BenchReport& report, const std::string& folder) {
    PagePictures pictures;
    for (size_t s = 0; s < report.scenes.size(); ++s) {
        const ScenePictures scene(report, folder, s);
        if (!scene.any()) continue;
        const std::string name = escapeHtml(report.scenes[s].name);
        const auto budget = scene.commonBudget();
        if (budget)
            pictures.figures += fmt::format("<h3>{}, {}</h3>\n<div class=\"strip\">\n{}</div>\n", name,
                                            budgetName(report.budgets[*budget]), scene.strip(*budget));
        const std::string rest = scene.rest(budget);
        if (!rest.empty())
            pictures.gallery += fmt::format("<h3>{}</h3>\n<div class=\"gallery\">\n{}</div>\n", name, rest);
    }
    return pictures;
}

}  // namespace drc
