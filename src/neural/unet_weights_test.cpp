#include "neural/unet_weights.h"

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

class UNetWeightsFile : public FolderTest {
  protected:
    void SetUp() override { shape_.width = 4; }

    // Saves random weights after `change` has modified them and their metadata.
    template <typename Change>
    void save(Change change) {
        const auto weights = UNetWeights::random(shape_, 1);
        auto convs = weights->convs();
        StringMap metadata = shape_.toMetadata();
        change(convs, metadata);
        std::vector<TensorToWrite> tensors;
        for (const auto& c : convs) {
            const auto filterInputs = int64_t(c.weight.size()) / (c.shape.out * c.shape.kernel * c.shape.kernel);
            tensors.push_back({c.shape.name + ".weight",
                               {c.shape.out, filterInputs, c.shape.kernel, c.shape.kernel},
                               c.weight.data()});
            tensors.push_back({c.shape.name + ".bias", {c.shape.out}, c.bias.data()});
        }
        writeSafetensors(path_, tensors, metadata);
    }
    std::string loadError() {
        const std::string text = errorOf([&] { UNetWeights::load(path_); });
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_EQ(text.find(path_), 0u) << text;
        return text;
    }

    const std::string path_ = path("a.safetensors");
    UNetShape shape_;
};

TEST_F(UNetWeightsFile, ComesBackAsSaved) {
    for (const UNetKind kind : kUNetKinds) {
        shape_.kind = kind;
        const auto weights = UNetWeights::random(shape_, 7);
        weights->save(path_, {{"projection", "equal-area"}, {"data", "none"}});
        const auto back = UNetWeights::load(path_);
        EXPECT_EQ(back->shape(), shape_);
        EXPECT_EQ(back->projection(), "equal-area");
        EXPECT_EQ(back->metadata().at("data"), "none");
        EXPECT_EQ(back->hash().size(), 16u);
        ASSERT_EQ(back->convs().size(), weights->convs().size());
        for (size_t i = 0; i < back->convs().size(); ++i) {
            EXPECT_EQ(back->convs()[i].weight, weights->convs()[i].weight);
            EXPECT_EQ(back->convs()[i].bias, weights->convs()[i].bias);
            EXPECT_EQ(back->convs()[i].scale, weights->convs()[i].scale);
            EXPECT_EQ(back->convs()[i].shift, weights->convs()[i].shift);
            EXPECT_EQ(back->convs()[i].scale.empty(), !back->convs()[i].shape.affine);
        }
    }
}

TEST_F(UNetWeightsFile, KnowsWhatItWasNotShown) {
    const auto weights = UNetWeights::random(shape_, 7);
    EXPECT_EQ(weights->ablation(), Ablation::None);
    weights->save(path_, {{"ablation", "distance"}});
    EXPECT_EQ(UNetWeights::load(path_)->ablation(), Ablation::Distance);
    weights->save(path_, {{"ablation", "colour"}});
    EXPECT_THAT(loadError(), HasSubstr("metadata 'ablation': the ablation must be none"));
}

TEST_F(UNetWeightsFile, HalfPrecisionIsClose) {
    const auto weights = UNetWeights::random(shape_, 7);
    for (DType type : {DType::F16, DType::BF16}) {
        weights->save(path_, {}, type);
        const auto back = UNetWeights::load(path_);
        for (size_t j = 0; j < weights->convs()[0].weight.size(); ++j)
            EXPECT_NEAR(back->convs()[0].weight[j], weights->convs()[0].weight[j], 0.004);
    }
}

TEST_F(UNetWeightsFile, MissingFile) { EXPECT_THAT(loadError(), HasSubstr("cannot open")); }

TEST_F(UNetWeightsFile, Truncated) {
    save([](auto&, auto&) {});
    const auto size = std::filesystem::file_size(path_);
    for (const uintmax_t keep : {uintmax_t(size - 1), uintmax_t(size / 2), uintmax_t(40), uintmax_t(3), uintmax_t(0)}) {
        std::filesystem::resize_file(path_, keep);
        EXPECT_THAT(loadError(), HasSubstr("truncated"));
    }
}

TEST_F(UNetWeightsFile, NotANumber) {
    save([](auto& convs, auto&) { convs[3].weight[5] = std::numeric_limits<float>::quiet_NaN(); });
    EXPECT_THAT(loadError(), HasSubstr("'enc1.1.weight' holds a value that is not finite"));
}

TEST_F(UNetWeightsFile, WrongShape) {
    save([](auto& convs, auto&) { convs[2].shape.in = 3, convs[2].weight.resize(8 * 3 * 9); });
    EXPECT_THAT(loadError(), HasSubstr("'enc1.0.weight' has shape [8, 3, 3, 3], not [8, 4, 3, 3]"));
}

TEST_F(UNetWeightsFile, MissingAndLeftOverTensors) {
    save([](auto& convs, auto&) { convs.pop_back(); });
    EXPECT_THAT(loadError(), HasSubstr("no tensor 'out.weight'"));
    save([](auto& convs, auto&) { convs.push_back(convs[0]), convs.back().shape.name = "more"; });
    EXPECT_THAT(loadError(), HasSubstr("tensors; this architecture has"));
}

TEST_F(UNetWeightsFile, WrongArchitecture) {
    save([](auto&, auto& metadata) { metadata["architecture"] = "resnet"; });
    EXPECT_THAT(loadError(), HasSubstr("architecture is 'resnet'; this program runs 'drc-unet-1'"));
    save([](auto&, auto& metadata) { metadata["width"] = "-4"; });
    EXPECT_THAT(loadError(), HasSubstr("metadata 'width' is '-4'"));
    save([](auto&, auto& metadata) { metadata["size"] = "20"; });
    EXPECT_THAT(loadError(), HasSubstr("cannot be halved"));
    save([](auto&, auto& metadata) { metadata["inputs"] = "3"; });
    EXPECT_THAT(loadError(), HasSubstr("'inputs'"));
}

TEST_F(UNetWeightsFile, LoadsFast) {
    shape_.width = 64;
    UNetWeights::random(shape_, 1)->save(path_, {});
    const auto start = std::chrono::steady_clock::now();
    UNetWeights::load(path_);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    RecordProperty("milliseconds", std::to_string(ms));
    EXPECT_LT(ms, 500);  // about 25 ms on an idle machine; a generous limit, since this is not a benchmark
}

}  // namespace
}  // namespace drc
