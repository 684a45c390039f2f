#include "training.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "base/error.h"
#include "maps/example_testing.h"
#include "validation.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

constexpr int kSize = 16;

// Shards of smooth maps with added noise, which a network quickly learns to remove.
class TrainingOnFiles : public testing::Test {
  protected:
    void SetUp() override {
        directory_ = fs::temp_directory_path() /
                     (std::string("drc_train_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(directory_);
        fs::create_directories(directory_);
        shape_.width = 8, shape_.levels = 3, shape_.size = kSize;
        options_.batch = 8, options_.examples = 8 * 60, options_.learningRate = 3e-3;
    }
    void TearDown() override { fs::remove_all(directory_); }

    void writeShard(const std::string& scene, int n, int r, const std::string& projection = "equal-area") {
        std::mt19937 random(unsigned(scene.size()) * 100 + unsigned(scene[0]));
        std::uniform_real_distribution<float> uniform(0, 1);
        const MapLayout layout(projectionFromName(projection), kSize);
        std::vector<TrainingExample> examples;
        for (int i = 0; i < n; ++i) {
            const float a = 6 * uniform(random), b = 6 * uniform(random);
            TrainingExample example = randomExample(layout, r, unsigned(i));
            for (size_t t = 0; t < 3 * kSize * kSize; ++t) {
                const float x = float(t % kSize) / kSize, y = float(t / kSize % kSize) / kSize;
                const float value = 1.2f + std::sin(a + 4 * x) * std::cos(b + 3 * y);
                example.target[t] = value;
                for (CapturedMap& input : example.inputs) input.radiance[t] = value * -std::log(1 - uniform(random));
            }
            for (CapturedMap& input : example.inputs) {
                input.normal.assign(input.normal.size(), 0);
                input.distance.assign(input.distance.size(), 2);
            }
            examples.push_back(example);
        }
        drc::writeShard((directory_ / (scene + ".examples")).string(), scene, layout, examples);
    }
    Dataset dataset() { return Dataset({directory_.string()}); }

    fs::path directory_;
    UNetShape shape_;
    TrainingOptions options_;
};

TEST_F(TrainingOnFiles, LossGoesDownAndBeatsTheNoise) {
    for (const char* scene : {"a", "bb", "ccc"}) writeShard(scene, 16, 2);
    const Dataset data = dataset();
    EXPECT_EQ(data.size(), 48u);
    const Split split = splitByScene(data, {"bb"}, 0);
    EXPECT_EQ(split.validation.size(), 16u);
    for (TargetMean mean : {TargetMean::Own, TargetMean::Input}) {
        options_.encoding.mean = mean;
        Training training(shape_, data, split.training, options_);
        double first = 0, last = 0;
        for (int i = 0; i < 60; ++i) {
            const double loss = training.step();
            (i < 5 ? first : last) += i < 5 || i >= 55 ? loss : 0;
        }
        EXPECT_LT(last, 0.7 * first);
        const Validation v = validate(training.average(), data, split.validation, options_.encoding);
        EXPECT_LT(v.network.log, v.none.log);
        EXPECT_LT(v.gaussian.log, v.none.log);
        EXPECT_LT(v.network.intensity, v.none.intensity);
        EXPECT_LT(training.learningRate(), 1e-4);
    }
}

TEST_F(TrainingOnFiles, ResumesAsIfItHadNotStopped) {
    writeShard("a", 12, 3);
    const Dataset data = dataset();
    const Split split = splitByScene(data, {}, 0.2);  // a single scene is split by example
    EXPECT_EQ(split.training.size() + split.validation.size(), 12u);
    EXPECT_FALSE(split.validation.empty());
    const std::string path = (directory_ / "state.ckpt").string();
    at::set_num_threads(1);
    Training whole(shape_, data, split.training, options_);
    for (int i = 0; i < 6; ++i) whole.step();
    whole.save(path);
    Training resumed(shape_, data, split.training, options_);
    resumed.load(path);
    EXPECT_EQ(resumed.done(), 6);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(whole.step(), resumed.step());
    const auto a = whole.average()->weights(), b = resumed.average()->weights();
    for (size_t i = 0; i < a->convs().size(); ++i) EXPECT_EQ(a->convs()[i].weight, b->convs()[i].weight);

    options_.seed = 99;
    Training other(shape_, data, split.training, options_);
    EXPECT_THROW(other.load(path), Error);
    std::ofstream(path) << "nonsense";
    EXPECT_THROW(resumed.load(path), Error);
}

TEST_F(TrainingOnFiles, BadShardsAreSkipped) {
    writeShard("good", 3, 1);
    writeShard("other-projection", 3, 1, "latlong");
    std::ofstream(directory_ / "bad.examples") << "nonsense";
    const Dataset data = dataset();
    EXPECT_EQ(data.size(), 3u);
    EXPECT_EQ(data.skippedShards(), 2);
    fs::remove(directory_ / "good.examples");
    fs::remove(directory_ / "other-projection.examples");
    EXPECT_THROW(dataset(), Error);
    EXPECT_THROW(Dataset({"/nonexistent"}), Error);
}

TEST_F(TrainingOnFiles, SplitKeepsScenesApart) {
    for (const char* scene : {"a", "b", "c", "d", "e", "f"}) writeShard(scene, 2, 1);
    const Dataset data = dataset();
    for (double fraction : {0.001, 0.3, 0.9}) {
        const Split split = splitByScene(data, {}, fraction);
        EXPECT_FALSE(split.training.empty());
        EXPECT_FALSE(split.validation.empty());
        EXPECT_EQ(split.training.size() + split.validation.size(), data.size());
        for (size_t i : split.training) EXPECT_EQ(split.validationScenes.count(data.scene(i)), 0u);
    }
    EXPECT_TRUE(splitByScene(data, {}, 0).validation.empty());
    EXPECT_THROW(splitByScene(data, {"nowhere"}, 0), Error);
}

TEST(GaussianBlur, KeepsAConstantAndSpreadsAPoint) {
    const torch::Tensor one = torch::ones({2, 3, 8, 8});
    EXPECT_LT((gaussianBlur(one, 1) - one).abs().max().item<double>(), 1e-5);
    torch::Tensor point = torch::zeros({1, 1, 17, 17});
    point[0][0][8][8] = 1;
    const torch::Tensor blurred = gaussianBlur(point, 1);
    EXPECT_NEAR(blurred.sum().item<double>(), 1, 1e-5);
    EXPECT_NEAR(blurred[0][0][8][8].item<double>(), 1 / (2 * 3.14159265), 1e-3);
}

}  // namespace
}  // namespace drc
