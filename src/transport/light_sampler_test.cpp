#include "transport/light_sampler.h"

#include <gtest/gtest.h>

#include "math/rng.h"
#include "math/warp.h"
#include "scene/chi_square.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

// `count` point lights of random intensity in each of two rooms, ten metres apart; optionally with a sky and a sun.
Scene twoRooms(int count, bool sky) {
    Scene scene;
    Pcg32 rng(6);
    // The lights of both rooms alternate, since nothing may depend on their order.
    for (int i = 0; i < 2 * count; ++i) {
        const Vec3 at(4 * rng.nextFloat() + (i % 2 ? 14.f : 0.f), 4 * rng.nextFloat(), 1 + 2 * rng.nextFloat());
        scene.lights.push_back(makePointLight(at, Rgb(0.5f + rng.nextFloat())));
        if (sky && i == 3) scene.lights.push_back(makeInfiniteLight(Transform(), Rgb(1.f)));
    }
    if (sky) scene.lights.push_back(makeDistantLight(Vec3(0, 0, 1), Rgb(1.f)));
    auto mesh = std::make_shared<TriangleMesh>();  // gives the scene an extent
    mesh->positions = {Vec3(0, 0, 0), Vec3(18, 0, 0), Vec3(0, 4, 3)};
    mesh->indices = {0, 1, 2};
    scene.primitives.push_back({mesh, nullptr, nullptr, nullptr, nullptr, nullptr});
    return scene;
}

void checkFrequencies(const Scene& scene, const Vec3& p) {
    const LightSampler sampler(scene);
    std::unordered_map<const Light*, double> observed;
    constexpr int kSamples = 40000;
    Pcg32 rng(8);
    for (int i = 0; i < kSamples; ++i) {
        const auto c = sampler.sample(p, rng.nextFloat());
        ASSERT_NE(c.light, nullptr);
        EXPECT_NEAR(c.probability / sampler.probability(p, c.light), 1, 1e-4);
        ++observed[c.light];
    }
    double sum = 0, statistic = 0, pooled = 0, pooledObserved = 0;
    int cells = 0;
    for (const LightPtr& light : scene.lights) {
        const double probability = sampler.probability(p, light.get()), e = probability * kSamples;
        sum += probability;
        if (e < 5) {
            pooled += e;
            pooledObserved += observed[light.get()];
            continue;
        }
        statistic += (observed[light.get()] - e) * (observed[light.get()] - e) / e;
        ++cells;
    }
    EXPECT_NEAR(sum, 1, 1e-4);
    if (pooled >= 5) {
        statistic += (pooledObserved - pooled) * (pooledObserved - pooled) / pooled;
        ++cells;
    }
    if (cells > 1) {
        EXPECT_GT(chiSquareUpperTail(statistic, cells - 1), test::kChiSquareLevel);
    }
}

TEST(LightSampler, ProbabilitiesAreThoseOfSamplingAndSumToOne) {
    for (const int count : {1, 5, 16, 200})
        for (const bool sky : {false, true}) {
            const Scene scene = twoRooms(count, sky);
            checkFrequencies(scene, Vec3(1, 2, 0));
            checkFrequencies(scene, Vec3(15, 1, 2));
        }
    Scene onlySuns;
    for (int i = 0; i < 40; ++i) onlySuns.lights.push_back(makeDistantLight(Vec3(0, 0, 1), Rgb(1.f + float(i))));
    checkFrequencies(onlySuns, Vec3(0, 0, 0));
}

TEST(LightSampler, NoLightsAndOne) {
    Scene scene;
    EXPECT_EQ(LightSampler(scene).sample(Vec3(0, 0, 0), 0.5f).light, nullptr);
    scene.lights = {makePointLight(Vec3(0, 0, 1), Rgb(1.f)), makePointLight(Vec3(0, 0, 1), Rgb(0.f))};
    const LightSampler one(scene);
    EXPECT_EQ(one.sample(Vec3(0, 0, 0), 0.99f).light, scene.lights[0].get());
    EXPECT_EQ(one.sample(Vec3(0, 0, 0), 0.5f).probability, 1);
    EXPECT_EQ(one.probability(Vec3(0, 0, 0), scene.lights[1].get()), 0);
    EXPECT_TRUE(one.infiniteLights().empty());
}

TEST(LightSampler, TheOtherRoomsLightsAreRare) {
    for (const int count : {8, 400}) {
        const Scene scene = twoRooms(count, false);
        const LightSampler sampler(scene);
        const Vec3 p(2, 2, 0);
        double other = 0;
        for (size_t i = 1; i < scene.lights.size(); i += 2) other += sampler.probability(p, scene.lights[i].get());
        EXPECT_LT(other, 0.12) << count;
    }
}

// Compares the variance of the irradiance in one of the rooms with that of choosing lights by power alone.
TEST(LightSampler, LessNoiseThanByPower) {
    const Scene scene = twoRooms(500, false);
    const LightSampler sampler(scene);
    std::vector<float> powers;
    for (const LightPtr& l : scene.lights) powers.push_back(luminance(l->power(1)));
    const Distribution1D byPower(powers);
    Pcg32 rng(10);
    for (const Vec3& p : {Vec3(1, 3, 0), Vec3(16, 2, 1)}) {
        const auto arriving = [&](const Light& light) {
            const auto s = light.sample(p, Vec2(0, 0));
            return double(s->radiance.x * std::max(0.f, s->wi.z));
        };
        RunningMean tree, power;
        double exact = 0;
        for (const LightPtr& l : scene.lights) exact += arriving(*l);
        for (int i = 0; i < 30000; ++i) {
            const auto c = sampler.sample(p, rng.nextFloat());
            tree.add(arriving(*c.light) / c.probability);
            const DiscreteSample s = byPower.sampleDiscrete(rng.nextFloat());
            power.add(arriving(*scene.lights[size_t(s.index)]) / s.probability);
        }
        EXPECT_NEAR(tree.mean(), exact, 4 * std::sqrt(tree.variance()));
        EXPECT_LT(tree.variance(), 0.4 * power.variance());
    }
}

}  // namespace
}  // namespace drc
