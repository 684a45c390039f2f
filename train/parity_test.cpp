// The forward passes of libtorch and oneDNN must agree for the same weights: what was trained is what runs.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "model.h"
#include "neural/unet.h"

namespace drc {
namespace {

// Compares the model with oneDNN running the same weights, on the same random input.
void expectAgreement(Model& model, const std::shared_ptr<const UNetWeights>& weights) {
    const torch::NoGradGuard noGrad;
    constexpr int kCount = 5;
    const UNetShape& shape = weights->shape();
    const torch::Tensor input = torch::randn({kCount, shape.inputs, 32, 32}) * 0.3;
    const torch::Tensor expected = model->forward(input).contiguous();
    ASSERT_GT(expected.abs().mean().item<double>(), 0.01);
    for (Precision precision : {Precision::Fp32, Precision::Bf16}) {
        if (precision == Precision::Bf16 && !cpuHasBf16()) continue;
        UNet net(weights, 8, precision);
        torch::Tensor output = torch::empty_like(expected);
        net.run(input.data_ptr<float>(), output.data_ptr<float>(), kCount);
        const double error = (output - expected).abs().max().item<double>();
        testing::Test::RecordProperty(precision == Precision::Fp32 ? "fp32" : "bf16", fmt::format("{:.2g}", error));
        if (precision == Precision::Fp32) {
            EXPECT_LT(error, 1e-4);
            continue;
        }
        // bestPrecision() promises an error of at most .02, assuming that whole maps have at most two and a half times
        // the error that bf16Error() finds. Checks that assumption for all weights, including those that it would run
        // in fp32.
        EXPECT_LT(error, std::max(2e-2, 2.5 * bf16Error(*weights)));
    }
}

class Parity : public testing::TestWithParam<std::tuple<UNetKind, int, int>> {};

TEST_P(Parity, LibtorchAndOneDnnAgree) {
    UNetShape shape;
    std::tie(shape.kind, shape.width, shape.inputs) = GetParam();
    torch::manual_seed(3);
    Model model(shape);
    model->setWeights(*UNetWeights::random(shape, 13));
    model->eval();

    // Through a file, so that exporting is tested as well.
    const auto path =
        std::filesystem::temp_directory_path() /
        fmt::format("drc_parity_{}_{}_{}.safetensors", unetKindName(shape.kind), shape.width, shape.inputs);
    model->weights()->save(path.string(), {{"projection", "equal-area"}});
    const auto weights = UNetWeights::load(path.string());
    std::filesystem::remove(path);
    expectAgreement(model, weights);
}

class ShippedParity : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Networks, ShippedParity, testing::Values("drc-fast", "drc", "paper-k64"));

TEST_P(ShippedParity, LibtorchAndOneDnnAgree) {
    const auto weights = UNetWeights::load(fmt::format("models/{}.safetensors", GetParam()));
    if (cpuHasBf16()) {
        EXPECT_EQ(bestPrecision(*weights), Precision::Bf16);
    }
    Model model(weights->shape());
    model->setWeights(*weights);
    model->eval();
    torch::manual_seed(5);
    expectAgreement(model, weights);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Parity,
                         testing::Combine(testing::ValuesIn(kUNetKinds), testing::Values(8, 16, 32),
                                          testing::Values(kPlainPlanes, kGuidedPlanes)));

// The running statistics of a training become the exported scale and shift.
TEST(ParityOfNetworks, NormalisationAfterLearning) {
    UNetShape shape;
    shape.kind = UNetKind::Paper;
    shape.width = 8;
    torch::manual_seed(4);
    Model model(shape);
    const torch::NoGradGuard noGrad;
    model->train();
    for (int i = 0; i < 20; ++i) model->forward(torch::randn({8, 7, 32, 32}) * 0.5 + 0.2);
    model->eval();
    const torch::Tensor input = torch::randn({3, 7, 32, 32}) * 0.3;
    const torch::Tensor expected = model->forward(input).contiguous();
    torch::Tensor output = torch::empty_like(expected);
    UNet(model->weights(), 8, Precision::Fp32).run(input.data_ptr<float>(), output.data_ptr<float>(), 3);
    EXPECT_LT((output - expected).abs().max().item<double>(), 1e-4);
    ASSERT_GT(expected.abs().mean().item<double>(), 0.01);
}

}  // namespace
}  // namespace drc
