#include "app/evaluation_samples.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/evaluation_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

using Json = nlohmann::ordered_json;

class EvaluationSamplesTest : public EvaluationTest {
  protected:
    EvaluationSamplesTest() { std::filesystem::create_directories(path("pictures")); }

    SampleSettings settings(size_t count) const { return {count, 1, path("pictures")}; }
    bool isPicture(const Json& name) const {
        return readLinearRgb(path("pictures/" + name.get<std::string>())).width() == 32;
    }

    const Evaluation evaluation =
        run({network("a.safetensors", "equal-area", 1), network("b.safetensors", "latlong", 2)});
};

TEST_F(EvaluationSamplesTest, AreAsManyAsAskedFor) {
    EXPECT_EQ(writeSamples(evaluation, 0, settings(0)).size(), 0u);
    EXPECT_EQ(writeSamples(evaluation, 0, settings(2)).size(), 2u);
    EXPECT_EQ(writeSamples(evaluation, 1, settings(100)).size(), 5u);
}

TEST_F(EvaluationSamplesTest, NameThePicturesOfEachMethod) {
    for (const Json& sample : writeSamples(evaluation, 0, settings(2))) {
        ASSERT_EQ(sample["methods"].size(), 3u);
        for (const char* what : {"distance", "normals", "albedo", "reference"}) EXPECT_TRUE(isPicture(sample[what]));
        for (const Json& method : sample["methods"])
            EXPECT_TRUE(isPicture(method["picture"]) && isPicture(method["error"])) << method;
        EXPECT_GT(sample["white"], 0);
    }
    EXPECT_TRUE(std::filesystem::exists(path("pictures/" + writeErrorScale(settings(2)))));
}

// No picture of one group or example takes the name of another's.
TEST_F(EvaluationSamplesTest, HaveNamesOfTheirOwn) {
    writeSamples(evaluation, 0, settings(100));
    writeSamples(evaluation, 1, settings(100));
    const auto files = std::filesystem::directory_iterator(path("pictures"));
    EXPECT_EQ(std::distance(begin(files), end(files)), 2 * 5 * 10);
}

TEST_F(EvaluationSamplesTest, HaveTheScoresThatWereEvaluated) {
    const EvaluatedGroup& group = evaluation.groups[0];
    const Json samples = writeSamples(evaluation, 0, settings(100));
    for (size_t i = 0; i < samples.size(); ++i)
        for (size_t m = 0; m < group.methods.size(); ++m)
            EXPECT_NEAR(samples[i]["methods"][m]["l1"].get<double>(), group.methods[m].scores[i].asRendered.l1, 1e-6);
}

// Maps too small for SSIM's window have none.
TEST_F(EvaluationSamplesTest, OfSmallMapsHaveNoSsim) {
    const MapLayout small(Projection::EqualArea, 8);
    writeShard(path("small.examples"), "one", small, examples(small, {1, 2}));
    const Json samples = writeSamples(evaluate({{path("small.examples")}, {}, false, false}), 0, settings(1));
    EXPECT_TRUE(samples[0]["methods"][0]["ssim"].is_null());
    EXPECT_FALSE(samples[0]["methods"][0]["l1"].is_null());
}

}  // namespace
}  // namespace drc
