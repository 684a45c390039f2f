#include "scene/lights/light_tree.h"

#include <gtest/gtest.h>

#include "math/distribution.h"
#include "math/warp.h"
#include "scene/chi_square.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

// Small one- and two-sided panels and points inside a box.
std::vector<LightReach> someLights(int count, uint64_t seed) {
    Pcg32 rng(seed);
    std::vector<LightReach> lights;
    for (int i = 0; i < count; ++i) {
        LightReach r;
        const Vec3 at(10 * rng.nextFloat(), 6 * rng.nextFloat(), 3 * rng.nextFloat());
        r.bounds.extend(at);
        r.axis = sampleUniformSphere(rng.nextVec2());
        r.intensity = 0.1f + rng.nextFloat();
        if (i % 3 != 0) {
            r.bounds.extend(at + Vec3(0.1f, 0.1f, 0.05f));
            r.spread = 0;
            r.twoSided = i % 3 == 1;
        }
        lights.push_back(r);
    }
    return lights;
}

void checkFrequencies(const LightTree& tree, int count, const Vec3& p, int samples) {
    Pcg32 rng(9);
    std::vector<double> observed(size_t(count) + 1), expected(size_t(count) + 1);
    for (int i = 0; i < samples; ++i) {
        const LightTree::Choice c = tree.sample(p, rng.nextFloat());
        if (c.index < 0) {
            ++observed.back();
            continue;
        }
        ++observed[size_t(c.index)];
        EXPECT_NEAR(c.probability / tree.probability(p, c.index), 1, 1e-4);
        EXPECT_TRUE(c.uRemapped >= 0 && c.uRemapped < 1);
    }
    double sum = 0, statistic = 0, pooled = 0, pooledObserved = 0;
    int cells = 0;
    for (int i = 0; i < count; ++i) sum += expected[size_t(i)] = tree.probability(p, i);
    EXPECT_LE(sum, 1 + 1e-4);
    expected.back() = std::max(0.0, 1 - sum);
    for (size_t i = 0; i < expected.size(); ++i) {
        const double e = expected[i] * samples;
        if (e < 5) {
            pooled += e;
            pooledObserved += observed[i];
            continue;
        }
        statistic += (observed[i] - e) * (observed[i] - e) / e;
        ++cells;
    }
    if (pooled >= 5) {
        statistic += (pooledObserved - pooled) * (pooledObserved - pooled) / pooled;
        ++cells;
    }
    ASSERT_GT(cells, 1);
    EXPECT_GT(chiSquareUpperTail(statistic, cells - 1), test::kChiSquareLevel);
}

TEST(LightTree, ProbabilitiesAreThoseOfSampling) {
    for (const int count : {2, 3, 40, 300}) {
        const LightTree tree(someLights(count, 5));
        for (const Vec3& p : {Vec3(5, 3, 1), Vec3(-4, 2, 2), Vec3(0.1f, 0.1f, 0.1f), Vec3(100, 80, -50)})
            checkFrequencies(tree, count, p, 30000);
    }
}

TEST(LightTree, ProbabilitiesSumToOneWhereEveryBranchHasLight) {
    // Points emit in all directions, so sampling must never fail.
    std::vector<LightReach> lights = someLights(999, 3);
    for (LightReach& r : lights) r.spread = kPi;
    const LightTree tree(lights);
    Pcg32 rng(4);
    for (int i = 0; i < 5; ++i) {
        const Vec3 p = sampleUniformSphere(rng.nextVec2()) * (20 * rng.nextFloat());
        double sum = 0;
        for (int k = 0; k < 999; ++k) sum += tree.probability(p, k);
        EXPECT_NEAR(sum, 1, 1e-4);
    }
}

TEST(LightTree, FarDimAndAvertedLightsAreChosenRarely) {
    const auto panel = [](const Vec3& at, const Vec3& axis, float intensity) {
        LightReach r;
        r.bounds.extend(at);
        r.axis = axis;
        r.spread = 0;
        r.intensity = intensity;
        return r;
    };
    const Vec3 down(0, 0, -1), up(0, 0, 1);
    const std::vector<LightReach> lights = {panel(Vec3(0, 0, 2), down, 1), panel(Vec3(0, 0.5f, 2), up, 1),
                                            panel(Vec3(40, 0, 2), down, 1), panel(Vec3(0.5f, 0, 2), down, 0.01f)};
    const LightTree tree(lights);
    const Vec3 p(0, 0, 0);
    EXPECT_GT(tree.probability(p, 0), 0.9f);
    EXPECT_LT(tree.probability(p, 1), 1e-3f);
    EXPECT_LT(tree.probability(p, 2), 1e-2f);
    EXPECT_LT(tree.probability(p, 3), 0.05f);
    // Lights without intensity are never chosen.
    const std::vector<LightReach> dark = {panel(Vec3(0, 0, 1), down, 0)};
    EXPECT_TRUE(LightTree(dark).empty());
    EXPECT_EQ(LightTree(dark).sample(p, 0.5f).index, -1);
    EXPECT_EQ(LightTree(dark).probability(p, 0), 0);
}

TEST(LightTree, DepthGrowsWithTheLogarithm) {
    EXPECT_LE(LightTree(someLights(10000, 1)).depth(), 32);
    // Many lights at the same point are simply halved.
    std::vector<LightReach> same(1000, someLights(1, 1)[0]);
    EXPECT_LE(LightTree(same).depth(), 11);
}

// From thousands of points, the variance of the irradiance must be far less than when lights are chosen by power alone.
TEST(LightTree, LessNoiseThanByPower) {
    const std::vector<LightReach> lights = [] {
        std::vector<LightReach> all = someLights(2000, 8);
        for (LightReach& r : all) r.bounds.max = r.bounds.min;
        return all;
    }();
    const LightTree tree(lights);
    const auto arriving = [&](size_t i, const Vec3& p) {
        const Vec3 d = p - lights[i].bounds.min;
        const float cosine = dot(lights[i].axis, d) / length(d);
        const float share = lights[i].spread > 0 ? 1 : lights[i].twoSided ? std::abs(cosine) : std::max(0.f, cosine);
        return double(lights[i].intensity * share / lengthSquared(d));
    };
    std::vector<float> power;
    for (const LightReach& r : lights) power.push_back(r.intensity);
    const Distribution1D distribution(power);
    Pcg32 rng(2);
    for (const Vec3& p : {Vec3(3, 3, 1), Vec3(12, 3, 1.5f)}) {
        RunningMean byTree, byPower;
        double exact = 0;
        for (size_t i = 0; i < lights.size(); ++i) exact += arriving(i, p);
        for (int k = 0; k < 40000; ++k) {
            const LightTree::Choice c = tree.sample(p, rng.nextFloat());
            byTree.add(c.index < 0 ? 0 : arriving(size_t(c.index), p) / c.probability);
            const DiscreteSample s = distribution.sampleDiscrete(rng.nextFloat());
            byPower.add(arriving(size_t(s.index), p) / double(s.probability));
        }
        EXPECT_NEAR(byTree.mean(), exact, 4 * std::sqrt(byTree.variance()));
        EXPECT_LT(byTree.variance(), 0.5 * byPower.variance());
    }
}

}  // namespace
}  // namespace drc
