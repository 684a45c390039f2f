#include "app/evaluation.h"

#include <gtest/gtest.h>

#include "app/evaluation_testing.h"
#include "maps/iispt_folder.h"
#include "maps/network_map_denoiser.h"

namespace drc {
namespace {

std::vector<std::string> names(const EvaluatedGroup& group) {
    std::vector<std::string> result;
    for (const EvaluatedMethod& method : group.methods) result.push_back(method.name);
    return result;
}
using Names = std::vector<std::string>;
using Pairs = std::vector<std::pair<size_t, size_t>>;

TEST_F(EvaluationTest, RunsEachNetworkOnItsOwnProjection) {
    const std::string a = network("a.safetensors", "equal-area", 1), b = network("b.safetensors", "latlong", 2),
                      c = network("c.safetensors", "equal-area", 3);
    const Evaluation evaluation = run({a, b, c});
    ASSERT_EQ(evaluation.groups.size(), 2u);
    EXPECT_EQ(evaluation.examples, 10u);
    EXPECT_EQ(evaluation.files, 4);
    EXPECT_EQ(evaluation.skipped, 0);
    EXPECT_EQ(names(evaluation.groups[0]), Names({"none", "gaussian", "a", "c"}));
    EXPECT_EQ(names(evaluation.groups[1]), Names({"none", "gaussian", "b"}));
    EXPECT_EQ(evaluation.groups[0].name(), "equal-area");
    EXPECT_EQ(evaluation.groups[1].name(), "latlong");
    for (const EvaluatedGroup& group : evaluation.groups)
        for (const EvaluatedMethod& method : group.methods) EXPECT_EQ(method.scores.size(), 5u);
}

// Of the method's map denoiser on the example that the key names.
TEST_F(EvaluationTest, ScoresBelongToTheirExamplesAndMethods) {
    const Evaluation evaluation = run({network("a.safetensors", "equal-area", 1)});
    const EvaluatedGroup& group = evaluation.groups[0];
    const auto weights = UNetWeights::load(path("a.safetensors"));
    const auto mapDenoiser = makeNetworkMapDenoiser(weights, kEqualArea);
    for (size_t i = 0; i < group.examples.size(); ++i) {
        const ExampleKey& key = group.examples[i];
        TrainingExample example;
        group.files[key.file].source->load(key.index, 0, 1, example);
        EXPECT_EQ(key.viewpoint, example.viewpoint);
        EXPECT_EQ(key.film, example.film);
        EXPECT_EQ(group.scene(key), i < 3 ? "one" : kHostileScene);
        EXPECT_EQ(group.methods[0].scores[i].asRendered.l1,
                  scoreMap(example.inputs[0].radiance, example.target, kEqualArea).l1);
        mapDenoiser->denoise(example.inputs, kEqualArea);
        EXPECT_NEAR(group.methods[2].scores[i].asRendered.l1,
                    scoreMap(example.inputs[0].radiance, example.target, kEqualArea).l1, 1e-6);
    }
}

TEST_F(EvaluationTest, PairsViewpointsOfTheSamePlace) {
    const Evaluation evaluation = run({network("a.safetensors", "equal-area", 1)});
    EXPECT_EQ(sharedViewpoints(evaluation.groups[0], evaluation.groups[1]), Pairs({{0, 0}, {1, 1}, {2, 2}}));
    // One file of three, in another order of files.
    writeShard(path("zz.examples"), "one", kLatLong, examples(kLatLong, {8, 2, 9}));
    const Evaluation other = evaluate({{path("zz.examples"), path("ll/two.examples")}, {}, false, false});
    EXPECT_EQ(sharedViewpoints(evaluation.groups[0], other.groups[0]), Pairs({{1, 3}}));
}

TEST_F(EvaluationTest, AScenePresentTwiceIsPairedOnce) {
    std::filesystem::copy_file(path("ll/one.examples"), path("ll/again.examples"));
    const Evaluation evaluation = run({network("a.safetensors", "equal-area", 1)});
    EXPECT_EQ(sharedViewpoints(evaluation.groups[0], evaluation.groups[1]).size(), 3u);
    EXPECT_EQ(sharedViewpoints(evaluation.groups[1], evaluation.groups[0]).size(), 3u);
}

TEST_F(EvaluationTest, NamesOfOneStemArePaths) {
    const std::string a = network("x/net.safetensors", "equal-area", 1),
                      b = network("y/net.safetensors", "equal-area", 2),
                      c = network("none.safetensors", "equal-area", 3), d = network("d.safetensors", "equal-area", 4);
    EXPECT_EQ(names(run({a, b, c, d}).groups[0]), Names({"none", "gaussian", a, b, c, "d"}));
}

TEST_F(EvaluationTest, RefusesNetworksThatCannotBeEvaluated) {
    const std::string a = network("a.safetensors", "equal-area", 1), small = network("s.safetensors", "latlong", 1, 16);
    EXPECT_EQ(errorOf([&] { run({a, a}); }), "the weights " + a + " are named twice");
    const std::string error = errorOf([&] { run({a, small}); });
    EXPECT_EQ(error.find(small + ": the network was trained on maps of 16x16 texels"), 0u) << error;
    EXPECT_NE(errorOf([&] { run({path("missing.safetensors")}); }), "");
    EXPECT_NE(errorOf([&] { evaluate({{folder_.write("no.examples", "text")}, {a}, false, false}); }), "");
}

TEST_F(EvaluationTest, SkipsWhatCannotBeRead) {
    folder_.write("ea/broken.examples", "no shard");
    const Evaluation evaluation = run({network("a.safetensors", "equal-area", 1)});
    EXPECT_EQ(evaluation.skipped, 1);
    EXPECT_EQ(evaluation.examples, 10u);
}

TEST_F(EvaluationTest, MapsOfAnotherSizeAreAGroupOfTheirOwn) {
    const MapLayout small(Projection::EqualArea, 16);
    writeShard(path("small.examples"), "one", small, examples(small, {1}));
    const Evaluation evaluation =
        evaluate({{path("ea"), path("small.examples")}, {network("a.safetensors", "equal-area", 1)}, false, false});
    ASSERT_EQ(evaluation.groups.size(), 2u);
    EXPECT_EQ(evaluation.groups[1].name(), "equal-area 16x16");
    EXPECT_EQ(names(evaluation.groups[1]), Names({"none", "gaussian"}));
}

// The authors' layout has neither albedos nor direct light.
TEST_F(EvaluationTest, ExamplesWithoutAlbedosAreAGroupOfTheirOwn) {
    TrainingExample example = randomExample(kLatLong, 1, 1);
    example.film = Vec2(3.5f, 4.5f);
    IisptWriter(path("theirs/room"), ShardHeader{.scene = "room", .layout = kLatLong}).write(example);
    const std::string guided = network("g.safetensors", "latlong", 1, 32, kGuidedPlanes),
                      plain = network("p.safetensors", "latlong", 1);
    const Evaluation evaluation = evaluate({{path("ll"), path("theirs")}, {guided, plain}, false, false});
    ASSERT_EQ(evaluation.groups.size(), 2u);
    EXPECT_EQ(evaluation.groups[0].name(), "latlong");
    EXPECT_EQ(names(evaluation.groups[0]), Names({"none", "gaussian", "g", "p"}));
    EXPECT_EQ(evaluation.groups[1].name(), "latlong without albedos");
    EXPECT_EQ(names(evaluation.groups[1]), Names({"none", "gaussian", "p"}));
    EXPECT_EQ(errorOf([&] {
                  evaluate({{path("theirs")}, {guided}, false, false});
              }),
              guided + ": the network sees albedos and direct light, and these examples have none");
}

TEST_F(EvaluationTest, AllInputsAreAveraged) {
    const EvaluationSettings first{
        {path("ea/one.examples")}, {network("a.safetensors", "equal-area", 1)}, false, false};
    EvaluationSettings all = first;
    all.allInputs = true;
    const Evaluation one = evaluate(first), both = evaluate(all);
    EXPECT_EQ(both.groups[0].files[0].inputs, 2);
    EXPECT_EQ(one.groups[0].files[0].inputs, 1);
    EXPECT_NE(one.groups[0].methods[0].scores[0].asRendered.l1, both.groups[0].methods[0].scores[0].asRendered.l1);
}

TEST_F(EvaluationTest, ChoosesTheSameViewpointsInEveryProjection) {
    std::vector<unsigned> seeds(40);
    for (unsigned i = 0; i < 40; ++i) seeds[i] = i;
    writeShard(path("a.examples"), "many", kEqualArea, examples(kEqualArea, seeds));
    writeShard(path("b.examples"), "many", kLatLong, examples(kLatLong, seeds));
    const Evaluation evaluation =
        evaluate({{path("a.examples"), path("b.examples")}, {network("a.safetensors", "equal-area", 1)}, false, false});
    const auto chosen = chooseExamples(evaluation.groups[0], 10, 1);
    EXPECT_EQ(chosen.size(), 10u);
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    EXPECT_EQ(std::adjacent_find(chosen.begin(), chosen.end()), chosen.end());
    EXPECT_EQ(chooseExamples(evaluation.groups[1], 10, 1), chosen);
    EXPECT_NE(chooseExamples(evaluation.groups[0], 10, 2), chosen);
    EXPECT_EQ(chooseExamples(evaluation.groups[0], 100, 1).size(), 40u);
    EXPECT_TRUE(chooseExamples(evaluation.groups[0], 0, 1).empty());
}

}  // namespace
}  // namespace drc
