#include "loss.h"

#include <gtest/gtest.h>

#include "maps/map_evaluation.h"

namespace drc {
namespace {

class LossOn : public testing::TestWithParam<Projection> {
  protected:
    MapLayout layout_{GetParam(), 32};
    // Random encoded radiance.
    torch::Tensor maps(int seed) const {
        torch::manual_seed(seed);
        return torch::log1p(torch::rand({4, 3, 32, 32}).pow(4) / 2);
    }
};

TEST_P(LossOn, IsNoneForEqualMaps) {
    const torch::Tensor t = maps(1);
    EXPECT_NEAR(Loss(layout_, 1)(t, t, torch::ones_like(t)).item<double>(), 0, 1e-6);
}

TEST_P(LossOn, WithoutIrradianceIsL1) {
    const torch::Tensor a = maps(1), b = maps(2);
    EXPECT_NEAR(Loss(layout_, 0)(a, b, torch::ones_like(a)).item<double>(), (a - b).abs().mean().item<double>(), 1e-7);
}

// An error on a surface with a third of another's albedo must count a third. The overall level of albedos must not
// matter.
TEST_P(LossOn, ErrorsCountByTheLightThatTheyMakeWrong) {
    const torch::Tensor t = maps(1), left = torch::zeros_like(t);
    left.slice(3, 0, 16).fill_(1);
    const torch::Tensor factor = 0.9 - 0.6 * left, wrongLeft = t + 0.1 * left, wrongRight = t + 0.1 * (1 - left);
    const Loss loss(layout_, 0);
    const double a = loss(wrongLeft, t, factor).item<double>(), b = loss(wrongRight, t, factor).item<double>();
    EXPECT_NEAR(a, 0.1 * 0.25, 1e-5);
    EXPECT_NEAR(b, 0.1 * 0.75, 1e-5);
    EXPECT_NEAR(loss(wrongLeft, t, factor * 0.1).item<double>(), a, 1e-6);
}

// The renderer scales channels to the captured energy anyway, so the loss must not depend on their scale.
TEST_P(LossOn, IrradianceDoesNotDependOnTheScaleOfAChannel) {
    const torch::Tensor t = maps(3);
    const torch::Tensor scales = torch::tensor({0.5f, 1.f, 3.f}).view({1, 3, 1, 1});
    const torch::Tensor scaled = torch::log1p(torch::expm1(t) * scales);
    EXPECT_LT(Loss(layout_, 1).irradianceErrors(scaled, t, torch::ones_like(t)).abs().max().item<double>(), 1e-4);
}

TEST_P(LossOn, OutputsThatStrayLeaveItFinite) {
    torch::Tensor output = maps(6).requires_grad_();
    const torch::Tensor t = maps(7), stray = torch::zeros_like(t);
    stray[0][1][3][4] = 1000;
    const torch::Tensor loss = Loss(layout_, 1)(output + stray, t, torch::ones_like(t));
    loss.backward();
    EXPECT_TRUE(std::isfinite(loss.item<double>()));
    EXPECT_TRUE(output.grad().isfinite().all().item<bool>());
}

TEST_P(LossOn, IrradianceIsWhatTheEvaluationMeasures) {
    const torch::Tensor a = maps(4), b = maps(5), factor = torch::rand_like(a) + 0.05;
    const torch::Tensor errors = Loss(layout_, 1).irradianceErrors(a, b, factor);
    for (int i = 0; i < 4; ++i) {
        const auto radiance = [&](const torch::Tensor& t) {
            const torch::Tensor r = (torch::expm1(t[i]) * factor[i]).contiguous();
            return std::vector<float>(r.data_ptr<float>(), r.data_ptr<float>() + r.numel());
        };
        std::vector<float> map = radiance(a);
        const std::vector<float> target = radiance(b);
        // The renderer scales each channel to the captured energy.
        const size_t texels = size_t(layout_.texels());
        for (size_t c = 0; c < 3; ++c) {
            double of = 0, to = 0;
            for (size_t k = 0; k < texels; ++k) {
                const double omega = layout_.solidAngle(int(k) / layout_.size());
                of += omega * map[c * texels + k], to += omega * target[c * texels + k];
            }
            for (size_t k = 0; k < texels; ++k) map[c * texels + k] *= float(to / of);
        }
        const double expected = scoreMap(map, target, layout_).irradiance;
        ASSERT_GT(expected, 1e-5);
        EXPECT_NEAR(errors[i].square().mean().item<double>(), expected, 1e-3 * expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Projections, LossOn, testing::Values(Projection::EqualArea, Projection::LatLong));

}  // namespace
}  // namespace drc
