#include "maps/radiance_map.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace drc {
namespace {

class RadianceMapOf : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(RadianceMap, RadianceMapOf, testing::Values(Projection::EqualArea, Projection::LatLong),
                         [](const auto& i) { return i.param == Projection::EqualArea ? "EqualArea" : "LatLong"; });

// A map whose texels are given functions of the world-space direction from its origin.
RadianceMap makeMap(const MapLayout& layout, const Vec3& origin, const Vec3& n,
                    const std::function<Rgb(Vec3)>& radiance, const std::function<float(Vec3)>& distance) {
    CapturedMap m;
    m.origin = origin;
    m.frame = Frame::fromNormal(n);
    const auto texels = size_t(layout.texels());
    m.radiance.resize(3 * texels);
    m.normal.resize(3 * texels);
    m.distance.resize(texels);
    for (int row = 0; row < layout.size(); ++row)
        for (int column = 0; column < layout.size(); ++column) {
            const auto i = size_t(row * layout.size() + column);
            const Vec3 d = m.frame.toWorld(layout.direction(column, row, Vec2(0.5f, 0.5f)));
            const Rgb value = radiance(d);
            for (size_t c = 0; c < 3; ++c) m.radiance[c * texels + i] = value[int(c)];
            m.distance[i] = distance(d);
        }
    return RadianceMap(m, layout);
}

float far(const Vec3&) { return -1; }

TEST_P(RadianceMapOf, ConstantRadianceIsExactEverywhere) {
    const MapLayout layout(GetParam(), 32);
    const Vec3 n = normalize(Vec3(0.3f, -0.5f, 0.8f));
    const RadianceMap map = makeMap(
        layout, Vec3(1, 2, 3), n, [](Vec3) { return Rgb(0.7f, 1.3f, 4); }, [](Vec3) { return 2.f; });
    std::mt19937 rng(3);
    std::normal_distribution<float> g;
    for (int i = 0; i < 500; ++i) {
        const Vec3 d = normalize(Vec3(g(rng), g(rng), g(rng)));  // also below the horizon
        const Vec3 x = Vec3(1, 2, 3) + Vec3(g(rng), g(rng), g(rng)) * 0.5f;
        for (const Rgb& r : {map.radiance(d), map.radianceAt(x, d)}) {
            EXPECT_NEAR(r.x, 0.7f, 0.7f * 1e-3f);
            EXPECT_NEAR(r.y, 1.3f, 1.3f * 1e-3f);
            EXPECT_NEAR(r.z, 4, 4 * 1e-3f);
        }
    }
}

TEST_P(RadianceMapOf, SamplesFollowThePdf) {
    const MapLayout layout(GetParam(), 32);
    const RadianceMap map = makeMap(
        layout, Vec3(0, 0, 0), Vec3(0, 0, 1), [](Vec3 d) { return Rgb(d.x > 0.5f ? 10.f : 0.1f + d.z); }, far);
    // The expectation of g / pdf is the integral of g for any g: here of 1 (giving the solid angle 2 pi) and of x^2.
    std::mt19937 rng(4);
    std::uniform_real_distribution<float> u(0, 1);
    double solidAngle = 0, xx = 0, solidAngle2 = 0, xx2 = 0;
    const int n = 200000;
    int elsewhere = 0;  // number of samples that rounding moved into the next texel
    for (int i = 0; i < n; ++i) {
        const auto s = map.sample(Vec2(u(rng), u(rng)));
        ASSERT_GT(s.pdf, 0);
        if (std::abs(map.pdf(s.d) - s.pdf) > 1e-3f * s.pdf + 1e-6f) ++elsewhere;
        const double a = 1 / double(s.pdf), b = sqr(s.d.x) / double(s.pdf);
        solidAngle += a, xx += b, solidAngle2 += a * a, xx2 += b * b;
    }
    EXPECT_LT(elsewhere, n / 10000);
    const auto check = [n](double sum, double sum2, double expected) {
        const double mean = sum / n, sigma = std::sqrt((sum2 / n - mean * mean) / n);
        EXPECT_NEAR(mean, expected, 4 * sigma);
    };
    check(solidAngle, solidAngle2, 2 * std::numbers::pi);
    check(xx, xx2, 2 * std::numbers::pi / 3);
}

TEST_P(RadianceMapOf, BrightTexelsAreSampledMore) {
    const RadianceMap map = makeMap(
        MapLayout(GetParam(), 32), Vec3(0, 0, 0), Vec3(0, 0, 1), [](Vec3 d) { return Rgb(d.x > 0.7f ? 50.f : 1.f); },
        far);
    EXPECT_GT(map.pdf(normalize(Vec3(1, 0, 0.5f))), 10 * map.pdf(normalize(Vec3(-1, 0, 0.5f))));
}

// Lookups interpolate, so around a small light they return more than the dark texels there contain. A density taken
// from the texel values alone would give those samples large weights.
TEST_P(RadianceMapOf, SamplesBesideASmallLightCountNoMoreThanOthers) {
    const MapLayout layout(GetParam(), 32);
    const Vec3 towards = normalize(Vec3(0.2f, 0.3f, 0.9f));
    const RadianceMap map = makeMap(
        layout, Vec3(0, 0, 0), Vec3(0, 0, 1),
        [&](const Vec3& d) { return Rgb(dot(d, towards) > 0.995f ? 100.f : 0.001f); }, far);
    Sampler sampler(1, 0);
    double sum = 0, squares = 0;
    constexpr uint32_t kSamples = 1 << 16;
    for (uint32_t i = 0; i < kSamples; ++i) {
        sampler.start(1, i);
        const auto s = map.sample(sampler.get2D());
        const double value = double(luminance(map.radiance(s.d))) * s.d.z / s.pdf;
        sum += value / kSamples, squares += value * value / kSamples;
    }
    RecordProperty("variance", std::to_string(squares / (sum * sum) - 1));
    EXPECT_LT(squares / (sum * sum) - 1, 1.5);  // 49 and 41 with a density from the texel values alone
}

// The map is on the floor of a room whose far wall (x = 2) is striped. From a point half a unit away, the same stripe
// is seen in another direction.
TEST_P(RadianceMapOf, ParallaxFindsTheSurfaceThatTheOtherPointSees) {
    const MapLayout layout(GetParam(), 64);
    // A box [-2,2]^2 x [0,3].
    const auto distanceIn = [](const Vec3& o, const Vec3& d) {
        float t = kInfinity;
        const float low[3] = {-2, -2, -1e-4f}, high[3] = {2, 2, 3};
        for (int i = 0; i < 3; ++i)
            if (std::abs(d[i]) > 1e-6f) t = std::min(t, ((d[i] > 0 ? high[i] : low[i]) - o[i]) / d[i]);
        return t;
    };
    const auto colour = [](const Vec3& p) {
        return Rgb(1 + 0.5f * std::sin(3 * p.x), 1 + 0.5f * std::sin(3 * p.y), p.z);
    };
    const Vec3 origin(0, 0, 0), x(0.5f, -0.3f, 0);
    const RadianceMap map = makeMap(
        layout, origin, Vec3(0, 0, 1), [&](Vec3 d) { return colour(origin + d * distanceIn(origin, d)); },
        [&](Vec3 d) { return distanceIn(origin, d); });
    std::mt19937 rng(5);
    std::normal_distribution<float> g;
    double corrected = 0, uncorrected = 0;
    for (int i = 0; i < 2000; ++i) {
        Vec3 d = normalize(Vec3(g(rng), g(rng), g(rng)));
        d.z = std::abs(d.z);
        if (d.z < 0.1f) continue;
        const Rgb truth = colour(x + d * distanceIn(x, d));
        const Rgb a = map.radianceAt(x, d) - truth, b = map.radiance(d) - truth;
        corrected += std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
        uncorrected += std::abs(b.x) + std::abs(b.y) + std::abs(b.z);
    }
    EXPECT_LT(corrected, 0.25 * uncorrected);
}

// A low point beside a wall sees, almost along the floor and below an open sky, a bright stretch of floor. The map,
// higher on the wall, sees that stretch well below the horizon, and the sky in the point's direction.
TEST_P(RadianceMapOf, ParallaxFindsWhatTheMapSeesInQuiteAnotherDirection) {
    const MapLayout layout(GetParam(), 64);
    const Vec3 origin(0, 0, 0.3f), x(0, 0, 0.1f);  // on the wall x = 0, facing +x; the floor is z = 0
    const auto distance = [](const Vec3& o, const Vec3& d) { return d.z < -1e-4f ? -o.z / d.z : -1.f; };
    const auto colour = [](const Vec3& p) { return p.x > 0.4f && p.x < 6 ? Rgb(1.f) : Rgb(0.f); };
    const auto seen = [&](const Vec3& o, const Vec3& d) {
        const float t = distance(o, d);
        return t > 0 ? colour(o + d * t) : Rgb(0.f);
    };
    const RadianceMap map = makeMap(
        layout, origin, Vec3(1, 0, 0), [&](Vec3 d) { return seen(origin, d); },
        [&](Vec3 d) { return distance(origin, d); });
    double truth = 0, corrected = 0, uncorrected = 0;  // irradiances at x
    const MapLayout fine(Projection::EqualArea, 256);
    const Frame frame = Frame::fromNormal(Vec3(1, 0, 0));
    for (int i = 0; i < fine.texels(); ++i) {
        const Vec3 d = frame.toWorld(fine.direction(i % 256, i / 256, Vec2(0.5f, 0.5f)));
        truth += seen(x, d).x * d.x;
        corrected += map.radianceAt(x, d).x * d.x;
        uncorrected += map.radiance(d).x * d.x;
    }
    EXPECT_NEAR(corrected / truth, 1, 0.12);
    EXPECT_GT(std::abs(uncorrected / truth - 1), 0.2);  // otherwise the test would show nothing
}

TEST(RadianceMap, HarmonicMeanDistanceOfASphereIsItsRadius) {
    const RadianceMap map = makeMap(
        MapLayout(Projection::EqualArea, 32), Vec3(0, 0, 0), Vec3(0, 1, 0), [](Vec3) { return Rgb(1.f); },
        [](Vec3) { return 3.5f; });
    EXPECT_NEAR(map.harmonicMeanDistance(), 3.5f, 0.01f);
}

TEST(RadianceMap, ABlackMapGivesBlackAndCanBeSampled) {
    const RadianceMap map = makeMap(
        MapLayout(Projection::EqualArea, 32), Vec3(0, 0, 0), Vec3(0, 0, 1), [](Vec3) { return Rgb(0.f); }, far);
    EXPECT_TRUE(isBlack(map.radiance(Vec3(0, 0, 1))));
    double solidAngle = 0;
    for (int i = 0; i < 100000; ++i) solidAngle += 1e-5 / map.sample(Vec2((float(i) + 0.5f) * 1e-5f, 0.6f)).pdf;
    EXPECT_NEAR(solidAngle, 2 * std::numbers::pi, 0.01);
}

}  // namespace
}  // namespace drc
