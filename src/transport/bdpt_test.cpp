#include "transport/bdpt.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

using Node = BidirectionalTracer::Node;
using Ends = BidirectionalTracer::Ends;

// Sum of the MIS weights over all strategies, that is, over every s that the path allows. It must be 1.
double sumOfWeights(const std::vector<Node>& nodes, const Ends& ends) {
    const size_t n = nodes.size();
    const auto canJoin = [&](size_t s) {
        const size_t t = n + 1 - s;
        if (s == 0) return ends.lightCanBeMet;
        if (t == 1) return s > 1 && ends.lensCanBeJoined && !nodes[0].specular;
        return !nodes[t - 2].specular && (s == 1 || !nodes[t - 1].specular);
    };
    double sum = 0;
    for (size_t s = 0; s <= n; ++s)
        if (canJoin(s)) sum += double(BidirectionalTracer::weight(nodes, s, ends));
    return sum;
}

TEST(Bdpt, WeightsOfAllWaysToMakeAPathAddUpToOne) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-2, 2);
    for (int i = 0; i < 2000; ++i) {
        std::vector<Node> nodes(1 + random() % 6);
        for (Node& node : nodes) node = {std::exp2(exponent(random)), std::exp2(exponent(random)), random() % 3 == 0};
        nodes.back().specular = false;
        const Ends ends{std::exp2(exponent(random)), random() % 4 != 0, random() % 4 != 0, 100};
        const double sum = sumOfWeights(nodes, ends);
        // Some paths cannot be made by any strategy, such as those to a delta light by mirrors alone.
        if (sum == 0) continue;
        ASSERT_NEAR(sum, 1, 1e-4) << "path " << i;
    }
}

TEST(Bdpt, WeightsFollowThePowerHeuristic) {
    // Lens, one vertex, light: the light is hit with pdf 3, or sampled with twice its own pdf of 2.
    const std::vector<Node> nodes{{5, 7, false}, {3, 2, false}};
    const Ends ends{2, true, false, 100};
    EXPECT_NEAR(BidirectionalTracer::weight(nodes, 0, ends), 9. / (9 + 16), 1e-6);
    EXPECT_NEAR(BidirectionalTracer::weight(nodes, 1, ends), 16. / (9 + 16), 1e-6);
    // In addition, 100 light paths reach the vertex with pdf 2 * 7, against 5 from the camera.
    const Ends joined{2, true, true, 100};
    const double byLight = 100. * 2 * 7 / 5;
    EXPECT_NEAR(BidirectionalTracer::weight(nodes, 2, joined), byLight * byLight / (9 + 16 + byLight * byLight), 1e-6);
}

TEST(Bdpt, WhatASpecularVertexHidesCountsForNothing) {
    // Seen in a mirror, a light can only be hit.
    const std::vector<Node> nodes{{5, 7, true}, {3, 2, false}};
    EXPECT_EQ(BidirectionalTracer::weight(nodes, 0, {2, true, true, 100}), 1);
}

TEST(Bdpt, WhereNoLightPathStartsLightsAreMetOrSampled) {
    const std::vector<Node> nodes{{5, 7, false}, {3, 2, false}};
    const Ends ends{2, true, true, 100, false};
    EXPECT_NEAR(BidirectionalTracer::weight(nodes, 0, ends), 9. / (9 + 16), 1e-6);
    EXPECT_NEAR(BidirectionalTracer::weight(nodes, 1, ends), 16. / (9 + 16), 1e-6);
}

TEST(Bdpt, WhatPathsFromTheCameraNeverTakeIsLeftOut) {
    // The light at its end can still be sampled.
    const std::vector<Node> hidden{{5, 7, false}, {0, 1, false}, {3, 2, false}}, direct{{5, 7, false}, {0, 2, false}};
    const Ends ends{2, true, true, 100};
    for (const size_t s : {0, 1, 2, 3}) EXPECT_EQ(BidirectionalTracer::weight(hidden, s, ends), 0);
    EXPECT_GT(BidirectionalTracer::weight(direct, 1, ends), 0);
}

}  // namespace
}  // namespace drc
