#include "neural/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/error.h"

namespace drc {
namespace {

constexpr size_t kTexels = 64;

TEST(Transforms, FollowTheFormulas) {
    std::mt19937 generator(1);
    std::exponential_distribution<float> random(2.f);
    std::vector<float> radiance(3 * kTexels), normal(3 * kTexels, 0.5f), distance(kTexels), planes(7 * kTexels);
    for (float& v : radiance) v = random(generator);
    for (float& v : distance) v = random(generator);
    distance[7] = -1;
    double m = 0, z = 0;
    for (float v : radiance) m += v / (3.0 * kTexels);
    double hit = 0;
    for (float v : distance) hit += v > 0 ? v / double(kTexels - 1) : 0;
    const auto inUnits = [hit](float v) { return v < 0 ? -1 : v / hit; };
    for (float v : distance) z += inUnits(v) / double(kTexels);
    EXPECT_NEAR(encodeInput({radiance.data(), normal.data(), distance.data(), kTexels}, planes.data()), m, 1e-6 * m);
    for (size_t i = 0; i < 3 * kTexels; ++i) {
        EXPECT_NEAR(planes[i], std::log1p(radiance[i] / (10 * m)) - 0.1, 1e-6);
        EXPECT_EQ(planes[3 * kTexels + i], 0.5f);
    }
    for (size_t i = 0; i < kTexels; ++i)
        EXPECT_NEAR(planes[6 * kTexels + i], std::log1p((inUnits(distance[i]) + 1) / (10 * (z + 1))) - 0.1, 1e-6);
    EXPECT_FLOAT_EQ(planes[6 * kTexels + 7], -0.1f);
}

// With albedos the network sees the light incident on the surfaces, which must not depend on their albedo.
TEST(Transforms, AlbedoIsDividedOutAndComesBack) {
    std::mt19937 generator(2);
    std::exponential_distribution<float> random(2.f);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> falling(3 * kTexels), albedo(3 * kTexels), radiance(3 * kTexels), normal(3 * kTexels),
        distance(kTexels, 1.f), direct(3 * kTexels), planes(13 * kTexels), expected(7 * kTexels), back(3 * kTexels);
    for (size_t i = 0; i < falling.size(); ++i) {
        falling[i] = random(generator), albedo[i] = i % 5 ? uniform(generator) : 0;
        radiance[i] = falling[i] * (albedo[i] + 0.05f);
        direct[i] = i % 2 ? radiance[i] : 0;
    }
    const float mean = encodeInput(
        {radiance.data(), normal.data(), distance.data(), kTexels, albedo.data(), direct.data()}, planes.data());
    encodeInput({falling.data(), normal.data(), distance.data(), kTexels}, expected.data());
    EXPECT_NEAR(mean, meanRadiance(falling.data(), falling.size()), 1e-6f);
    for (size_t i = 0; i < 7 * kTexels; ++i) EXPECT_NEAR(planes[i], expected[i], 1e-6f);
    for (size_t i = 0; i < 3 * kTexels; ++i) {
        EXPECT_EQ(planes[7 * kTexels + i], albedo[i]);
        EXPECT_NEAR(planes[10 * kTexels + i], i % 2 ? planes[i] : -0.1f, 1e-6f);
    }
    divideByAlbedo(radiance.data(), albedo.data(), radiance.size(), back.data());
    for (size_t i = 0; i < back.size(); ++i) EXPECT_NEAR(back[i], falling[i], 1e-6f * (1 + falling[i]));
    multiplyByAlbedo(back.data(), albedo.data(), back.size(), back.data());
    for (size_t i = 0; i < back.size(); ++i) EXPECT_NEAR(back[i], radiance[i], 1e-6f * (1 + radiance[i]));
    albedo[0] = std::nanf(""), albedo[1] = -1, albedo[2] = 3;
    encodeInput({radiance.data(), normal.data(), distance.data(), kTexels, albedo.data(), direct.data()},
                planes.data());
    EXPECT_EQ(planes[7 * kTexels], 0);
    EXPECT_EQ(planes[7 * kTexels + 1], 0);
    EXPECT_EQ(planes[7 * kTexels + 2], 1);
}

TEST(Transforms, TargetComesBack) {
    std::vector<float> radiance, encoded(200), back(200);
    for (int i = 0; i < 200; ++i) radiance.push_back(std::pow(10.f, -4 + 0.04f * float(i)));
    for (float scale : {1e-10f, 1.f, 1e6f}) {
        std::vector<float> scaled = radiance;
        for (float& v : scaled) v *= scale;
        const float mean = meanRadiance(scaled.data(), scaled.size());
        encodeTarget(scaled.data(), scaled.size(), mean, encoded.data());
        decodeOutput(encoded.data(), encoded.size(), mean, back.data());
        for (size_t i = 0; i < back.size(); ++i) EXPECT_NEAR(back[i], scaled[i], 1e-5 * scaled[i] + 3e-6 * mean);
    }
}

TEST(Transforms, BlackAndBrokenMapsStayFinite) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    std::vector<float> radiance(3 * kTexels, 0.f), normal(3 * kTexels, nan), distance(kTexels, -1.f),
        planes(7 * kTexels);
    EXPECT_EQ(encodeInput({radiance.data(), normal.data(), distance.data(), kTexels}, planes.data()), 0.f);
    for (size_t i = 0; i < 3 * kTexels; ++i) EXPECT_FLOAT_EQ(planes[i], -0.1f);
    for (size_t i = 0; i < 3 * kTexels; ++i) EXPECT_EQ(planes[3 * kTexels + i], 0);
    for (size_t i = 0; i < kTexels; ++i) EXPECT_FLOAT_EQ(planes[6 * kTexels + i], -0.1f);

    radiance[0] = inf, radiance[1] = nan, radiance[2] = -5, radiance[3] = 2, radiance[4] = 1e-45f;
    distance[0] = inf, distance[1] = nan, distance[2] = 3;
    encodeInput({radiance.data(), normal.data(), distance.data(), kTexels}, planes.data());
    for (float v : planes) EXPECT_TRUE(std::isfinite(v));

    std::vector<float> encoded(3), back(3);
    const float bright[3] = {3e38f, 1, 0};
    encodeTarget(bright, 3, 1e-30f, encoded.data());
    for (float v : encoded) EXPECT_TRUE(std::isfinite(v));
    const float wild[3] = {nan, 1000, -3};
    decodeOutput(wild, 3, 1e30f, back.data());
    for (float v : back) EXPECT_TRUE(std::isfinite(v) && v >= 0);
    decodeOutput(wild, 3, nan, back.data());
    for (float v : back) EXPECT_EQ(v, 0);
}

TEST(Transforms, DoNotDependOnBrightness) {
    std::vector<float> radiance(3 * kTexels), normal(3 * kTexels), distance(kTexels, 1.f), a(7 * kTexels),
        b(7 * kTexels);
    for (size_t i = 0; i < radiance.size(); ++i) radiance[i] = float(i % 13);
    encodeInput({radiance.data(), normal.data(), distance.data(), kTexels}, a.data());
    for (float& v : radiance) v *= 4096;
    encodeInput({radiance.data(), normal.data(), distance.data(), kTexels}, b.data());
    EXPECT_EQ(a, b);
}

TEST(Transforms, DoNotDependOnTheUnitOfLength) {
    std::vector<float> radiance(3 * kTexels, 1.f), normal(3 * kTexels), metres(kTexels), centimetres(kTexels),
        a(7 * kTexels), b(7 * kTexels);
    for (size_t i = 0; i < kTexels; ++i) {
        metres[i] = i % 7 ? 0.5f + 0.01f * float(i) : -1;
        centimetres[i] = metres[i] < 0 ? -1 : 100 * metres[i];
    }
    encodeInput({radiance.data(), normal.data(), metres.data(), kTexels}, a.data());
    encodeInput({radiance.data(), normal.data(), centimetres.data(), kTexels}, b.data());
    for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-5f);
}

TEST(Transforms, AblationsHideTheirPlanesAlone) {
    for (const Ablation a : {Ablation::None, Ablation::Normals, Ablation::Distance, Ablation::Both}) {
        EXPECT_EQ(parseAblation(ablationName(a)), a);
        std::vector<float> planes(7 * kTexels, 1.f);
        ablate(a, kTexels, planes.data());
        const bool normals = a == Ablation::Normals || a == Ablation::Both;
        const bool distance = a == Ablation::Distance || a == Ablation::Both;
        for (size_t i = 0; i < planes.size(); ++i) {
            const size_t plane = i / kTexels;
            const bool hidden = plane < 3 ? false : plane < 6 ? normals : distance;
            EXPECT_EQ(planes[i], hidden ? 0.f : 1.f) << i;
        }
    }
    EXPECT_THROW(parseAblation("colour"), Error);
}

}  // namespace
}  // namespace drc
