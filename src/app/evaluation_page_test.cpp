#include "app/evaluation_page.h"

#include <gtest/gtest.h>

#include "app/evaluation_testing.h"
#include "report/html_testing.h"

namespace drc {
namespace {

class EvaluationPageTest : public EvaluationTest {
  protected:
    std::string page(const std::vector<std::string>& weights, size_t samples) const {
        const Evaluation evaluation = run(weights);
        return evaluationPage(evaluation, makeReport(evaluation), {samples, 1});
    }
};

TEST_F(EvaluationPageTest, IsOneWellFormedFileThatFetchesNothing) {
    const std::string html = page({network("<i>&.safetensors", "equal-area", 1)}, 2);
    EXPECT_EQ(brokenNesting(html), "");
    for (const char* fetched : {"http:", "https:", "//www", "url(", "@import", "<link", "<script", "<iframe"})
        EXPECT_EQ(html.find(fetched), std::string::npos) << fetched;
    EXPECT_GT(occurrences(html, " src="), 0);
    EXPECT_EQ(occurrences(html, " src="), occurrences(html, " src=\"data:image/png;base64,iVBORw0K"));
}

TEST_F(EvaluationPageTest, EscapesNamesOfScenesNetworksAndMetadata) {
    const std::string html = page({network("<i>&.safetensors", "equal-area", 1)}, 10);
    for (const char* raw : {"<i>", "<b>&", "abc<def"}) EXPECT_EQ(html.find(raw), std::string::npos) << raw;
    for (const char* escaped : {"&lt;i&gt;&amp;", "&lt;b&gt;&amp;&quot;two&#39;", "abc&lt;def"})
        EXPECT_NE(html.find(escaped), std::string::npos) << escaped;
}

TEST_F(EvaluationPageTest, ShowsEveryMethodAndMeasureOfEveryProjection) {
    const std::string a = network("net-a.safetensors", "equal-area", 1), b = network("net-b.safetensors", "latlong", 2);
    const std::string html = page({a, b}, 2);
    // Six plots a projection, a box a method in each.
    EXPECT_EQ(occurrences(html, "<svg "), 12);
    EXPECT_EQ(occurrences(html, "<rect class=\"box\""), 12 * 3);
    // Scores, tests, and both again across projections.
    EXPECT_EQ(occurrences(html, "<table class=\"measures\">"), 5);
    for (const char* part : {">net-a against gaussian<", ">net-b against none<", ">gaussian against none<",
                             ">net-a against net-b<", ">mean, latlong<", "3 viewpoints that both have"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    for (const std::string& weights : {a, b})
        EXPECT_NE(html.find(UNetWeights::load(weights)->hash()), std::string::npos);
}

// Distance, normals, albedo, three methods with their errors, the reference, the scale of the error.
TEST_F(EvaluationPageTest, ShowsAsManyExamplesAsAskedFor) {
    const std::vector<std::string> weights{network("a.safetensors", "equal-area", 1),
                                           network("b.safetensors", "latlong", 2)};
    const std::string none = page(weights, 0), two = page(weights, 2), all = page(weights, 100);
    EXPECT_EQ(occurrences(none, "<img "), 0);
    EXPECT_EQ(occurrences(two, "class=\"example\""), 2 * 2);
    EXPECT_EQ(occurrences(two, "<img "), 2 * 2 * 11);
    EXPECT_EQ(occurrences(all, "class=\"example\""), 2 * 5);
    EXPECT_EQ(brokenNesting(all), "");
}

// The scores beside the pictures are those of the tables.
TEST_F(EvaluationPageTest, ScoresOfExamplesAreThoseEvaluated) {
    const Evaluation evaluation = run({network("a.safetensors", "equal-area", 1)});
    const std::string html = evaluationPage(evaluation, makeReport(evaluation), {100, 1});
    for (const EvaluatedGroup& group : evaluation.groups)
        for (const EvaluatedMethod& method : group.methods)
            for (const ExampleScores& scores : method.scores)
                EXPECT_NE(html.find(fmt::format("<dt>L1</dt><dd>{:.4f}</dd>", scores.asRendered.l1)), std::string::npos)
                    << method.name << " " << scores.asRendered.l1;
}

// Maps too small for SSIM's window have none.
TEST_F(EvaluationPageTest, SmallMapsHaveNoSsim) {
    const MapLayout small(Projection::EqualArea, 8);
    writeShard(path("small.examples"), "one", small, examples(small, {1, 2}));
    const Evaluation evaluation = evaluate({{path("small.examples")}, {}, false, false});
    const std::string html = evaluationPage(evaluation, makeReport(evaluation), {1, 1});
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_EQ(html.find(">nan"), std::string::npos);
    EXPECT_EQ(occurrences(html, "<rect class=\"box\""), 4 * 2);
}

}  // namespace
}  // namespace drc
