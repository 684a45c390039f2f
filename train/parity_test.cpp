// What was trained is what runs: libtorch's and oneDNN's forward passes of the same weights agree.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "model.h"
#include "neural/unet.h"

namespace drc {
namespace {

class Parity : public testing::TestWithParam<int> {};

TEST_P(Parity, LibtorchAndOneDnnAgree) {
    UNetShape shape;
    shape.width = GetParam();
    torch::manual_seed(3);
    Model model(shape);
    model->setWeights(*UNetWeights::random(shape, 11));
    model->eval();

    // By way of a file, so that the export is tested as well.
    const auto path = std::filesystem::temp_directory_path() / fmt::format("drc_parity_{}.safetensors", shape.width);
    model->weights()->save(path.string(), {{"projection", "equal-area"}});
    const auto weights = UNetWeights::load(path.string());
    std::filesystem::remove(path);

    const torch::NoGradGuard noGrad;
    constexpr int kCount = 5;
    const torch::Tensor input = torch::randn({kCount, 7, 32, 32}) * 0.3;
    const torch::Tensor expected = model->forward(input).contiguous();
    ASSERT_GT(expected.abs().mean().item<double>(), 0.01);
    for (Precision precision : {Precision::Fp32, Precision::Bf16}) {
        if (precision == Precision::Bf16 && !cpuHasBf16()) continue;
        torch::Tensor output = torch::empty_like(expected);
        UNet(weights, 8, precision).run(input.data_ptr<float>(), output.data_ptr<float>(), kCount);
        EXPECT_LT((output - expected).abs().max().item<double>(), precision == Precision::Fp32 ? 1e-4 : 2e-2);
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, Parity, testing::Values(8, 16, 32));

}  // namespace
}  // namespace drc
