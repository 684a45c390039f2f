#include "math/catmull_rom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace drc {
namespace {

const std::vector<float> kUneven = {-1, -0.9f, -0.5f, -0.1f, 0.2f, 0.25f, 0.7f, 1};

float interpolated(const SplineNodes& nodes, const std::function<float(int)>& value, float x) {
    const SplineWeights s = nodes.at(x);
    float sum = 0;
    for (int i = 0; i < 4; ++i) {
        if (s.weight[size_t(i)] == 0) continue;
        EXPECT_GE(s.node(i), 0);
        EXPECT_LT(s.node(i), nodes.size());
        sum += s.weight[size_t(i)] * value(s.node(i));
    }
    return sum;
}

TEST(CatmullRom, PassesThroughItsNodesAndIsExactForStraightLines) {
    const SplineNodes nodes(kUneven);
    for (int k = 0; k < nodes.size(); ++k)
        for (int i = 0; i < nodes.size(); ++i)
            EXPECT_NEAR(interpolated(
                            nodes, [&](int j) { return j == k ? 1.f : 0.f; }, nodes[i]),
                        i == k ? 1 : 0, 1e-6f);
    for (float x = -1; x <= 1; x += 0.01f)
        EXPECT_NEAR(interpolated(
                        nodes, [&](int j) { return 3 * nodes[j] + 2; }, x),
                    3 * x + 2, 1e-5f);
    // Beyond the ends: the values there.
    const auto line = [&](int j) { return nodes[j]; };
    EXPECT_EQ(interpolated(nodes, line, -3), -1);
    EXPECT_EQ(interpolated(nodes, line, 3), 1);
}

TEST(CatmullRom, ParabolasAreExactBetweenEvenNodes) {
    const SplineNodes nodes({0, 1, 2, 3});
    for (float x = 1; x <= 2; x += 0.05f)
        EXPECT_NEAR(interpolated(
                        nodes, [&](int j) { return nodes[j] * nodes[j]; }, x),
                    x * x, 1e-5f);
}

TEST(CatmullRom, SmoothAcrossNodes) {
    const SplineNodes nodes(kUneven);
    const auto value = [&](int j) { return std::sin(3 * nodes[j]); };
    for (int i = 1; i + 1 < nodes.size(); ++i) {
        const float h = 1e-3f, x = nodes[i], y = interpolated(nodes, value, x);
        EXPECT_NEAR((interpolated(nodes, value, x + h) - y) / h, (y - interpolated(nodes, value, x - h)) / h, 0.1f);
    }
}

// At a doubled node the value jumps, and each side is as if the other did not exist.
TEST(CatmullRom, BreakAtADoubledNode) {
    const SplineNodes nodes({-1, -0.5f, 0, 0, 0.5f, 1}), right({0, 0.5f, 1});
    const auto value = [&](int j) { return j < 3 ? 100.f : 1 + float(j * j); };
    for (float x = -1; x < 0; x += 0.1f) EXPECT_NEAR(interpolated(nodes, value, x), 100, 1e-4f);
    for (float x = 0; x < 1; x += 0.1f)
        EXPECT_NEAR(interpolated(nodes, value, x),
                    interpolated(
                        right, [&](int j) { return value(j + 3); }, x),
                    1e-4f);
    // Breaks at the ends are no segments either.
    const SplineNodes ends({0, 0, 1, 1});
    for (const float x : {0.f, 0.5f, 1.f})
        EXPECT_NEAR(interpolated(
                        ends, [&](int j) { return ends[j]; }, x),
                    x, 1e-6f);
}

TEST(CatmullRom, Integral) {
    for (const std::vector<float>& places : {kUneven, {-1, -0.5f, 0, 0, 0.5f, 1}, {0, 2}}) {
        const SplineNodes nodes(places);
        const auto value = [&](int j) { return std::exp(nodes[j]) + float(j == 3); };
        const std::vector<double> weights = nodes.integralWeights();
        double sum = 0, expected = 0;
        for (int i = 0; i < nodes.size(); ++i) sum += weights[size_t(i)] * value(i);
        constexpr int kSteps = 20000;
        const double length = places.back() - places.front();
        for (int i = 0; i < kSteps; ++i)
            expected +=
                interpolated(nodes, value, float(places.front() + length * (i + 0.5) / kSteps)) * length / kSteps;
        EXPECT_NEAR(sum, expected, 1e-4);
    }
}

}  // namespace
}  // namespace drc
