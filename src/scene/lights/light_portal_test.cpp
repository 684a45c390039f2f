#include <gtest/gtest.h>

#include "scene/chi_square.h"
#include "scene/lights/light.h"
#include "scene/lights/portal.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

using namespace test;

// A window of 2 by 1.2 in the plane x = 1, outward along +x.
const std::array<Vec3, 4> kWindow = {Vec3(1, -1, 0.4f), Vec3(1, -1, 1.6f), Vec3(1, 1, 1.6f), Vec3(1, 1, 0.4f)};

EnvironmentMap patches(int width, int height) {
    EnvironmentMap map{width, height, {}};
    std::mt19937 rng(9);
    for (int i = 0; i < width * height; ++i) {
        const float on = uniform(rng), value = uniform(rng);
        map.texels.push_back(on < 0.4f ? Rgb(0.f) : Rgb(0.2f + value, 0.5f, value));
    }
    return map;
}

struct Sky {
    const char* name;
    LightPtr environment;
    LightPtr light() const { return makePortalLight(environment, kWindow); }
};
void PrintTo(const Sky& sky, std::ostream* out) { *out << sky.name; }

std::vector<Sky> skies() {
    EnvironmentMap sunny{64, 32, std::vector<Rgb>(64 * 32, Rgb(0.3f))};
    sunny.texels[12 * 64 + 3] = Rgb(400.f);
    const Transform turned = Transform::rotate(70, Vec3(1, 2, 3));
    return {{"Constant", makeInfiniteLight(turned, Rgb(2.f))},
            {"Map", makeInfiniteLight(turned, Rgb(1.f), patches(24, 12))},
            {"Sun", makeInfiniteLight(Transform(), Rgb(1.f), sunny)}};
}

const Vec3 kLit[] = {Vec3(0, 0, 1), Vec3(-0.3f, 1.7f, 0.1f), Vec3(0.9f, 0.9f, 1.5f), Vec3(-0.5f, -1, 2.5f)};

class PortalLights : public testing::TestWithParam<Sky> {};
INSTANTIATE_TEST_SUITE_P(EverySky, PortalLights, testing::ValuesIn(skies()),
                         [](const auto& i) { return i.param.name; });

TEST_P(PortalLights, DirectionsFollowTheDensity) {
    const LightPtr light = GetParam().light();
    for (const Vec3& p : kLit) {
        const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
            const auto s = light->sample(p, uniform2(rng));
            if (!s) return std::nullopt;
            return s->wi;
        };
        const ChiSquare r = chiSquareTest(
            sample, [&](const Vec3& w) { return light->pdfEscaped(p, w); }, 40000, 8, 1e-6);
        EXPECT_GT(r.pValue, kChiSquareLevel) << "chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
        EXPECT_GE(r.degreesOfFreedom, 8);
        EXPECT_NEAR(r.pdfIntegral, 1, 2e-3) << p;
    }
}

TEST_P(PortalLights, LightAsMuchAsTheEnvironmentThroughAHole) {
    const Sky& sky = GetParam();
    const LightPtr light = sky.light();
    const Portal portal(kWindow);
    for (const Vec3& p : kLit) {
        Pcg32 rng(3);
        RunningMean bySample[4], byDirection[4];
        int different = 0;
        constexpr int kSamples = 60000;
        for (int i = 0; i < kSamples; ++i) {
            const Vec2 u = rng.nextVec2();
            const auto s = light->sample(p, u);
            const Rgb radiance = s ? light->escaped(p, s->wi) : Rgb(0.f);
            for (int k = 0; k < 4; ++k)
                bySample[k].add(s ? radiance.x / s->pdf * (k < 3 ? 1 + double(s->wi[k]) : 1.0) : 0.0);
            if (s) {
                EXPECT_EQ(s->distance, kInfinity);
                EXPECT_TRUE(isBlack(s->radiance)) << "escaped() has it";
                different += std::abs(light->pdfEscaped(p, s->wi) - s->pdf) > 1e-2f * s->pdf ||
                             (light->inverse(p, s->wi) - u).length() > 5e-3f;
            }
            // Uniform over the hemisphere before the portal.
            const Vec3 w = Frame::fromNormal(portal.outward()).toWorld(sampleUniformHemisphere(rng.nextVec2()));
            const bool passes = portal.isPassed(p, w);
            EXPECT_EQ(light->escaped(p, w), passes ? sky.environment->escaped(p, w) : Rgb(0.f));
            EXPECT_TRUE(isBlack(light->escaped(p, -w)));
            for (int k = 0; k < 4; ++k)
                byDirection[k].add(
                    passes ? sky.environment->escaped(p, w).x * 2 * kPi * (k < 3 ? 1 + double(w[k]) : 1.0) : 0.0);
        }
        EXPECT_LT(different, kSamples / 500);
        for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 1e-5, "moment");
        EXPECT_LT(bySample[3].variance(), 0.25 * byDirection[3].variance());
    }
}

TEST(PortalLight, GivesTheIrradianceOfARectangle) {
    // Four times the form factor of a corner above the centre of a parallel rectangle (PBR's and Howell's tables).
    const LightPtr light = makePortalLight(makeInfiniteLight(Transform(), Rgb(2.f)), kWindow);
    const double a = 1 / 1.5, b = 0.6 / 1.5;  // half sides over distance
    const double corner = 1 / (2 * std::numbers::pi) *
                          (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
                           b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b)));
    const Vec3 p(-0.5f, 0, 1), n(1, 0, 0);
    Pcg32 rng(5);
    RunningMean e;
    for (int i = 0; i < 20000; ++i) {
        const auto s = light->sample(p, rng.nextVec2());
        ASSERT_TRUE(s);
        e.add(light->escaped(p, s->wi).x * dot(n, s->wi) / s->pdf);
    }
    EXPECT_NEAR(e.mean(), 2 * std::numbers::pi * 4 * corner, 4 * std::sqrt(e.variance()) + 1e-3);
}

TEST(PortalLight, DoesNotShineOutside) {
    const LightPtr light = makePortalLight(makeInfiniteLight(Transform(), Rgb(2.f)), kWindow);
    const Vec3 outside(1.5f, 0, 1), inside(0, 0, 1);
    EXPECT_FALSE(light->sample(outside, Vec2(0.3f, 0.4f)));
    EXPECT_TRUE(isBlack(light->escaped(outside, Vec3(1, 0, 0))));
    EXPECT_TRUE(isBlack(light->escaped(outside, Vec3(-1, 0, 0))));
    EXPECT_EQ(light->pdfEscaped(outside, Vec3(1, 0, 0)), 0);
    EXPECT_EQ(light->escaped(inside, Vec3(1, 0, 0)), Rgb(2.f));
    EXPECT_TRUE(isBlack(light->escaped(inside, Vec3(-1, 0, 0))));
    // The corners in the opposite order: inside and outside change places.
    const LightPtr other =
        makePortalLight(makeInfiniteLight(Transform(), Rgb(2.f)), {kWindow[3], kWindow[2], kWindow[1], kWindow[0]});
    EXPECT_TRUE(isBlack(other->escaped(inside, Vec3(1, 0, 0))));
    EXPECT_EQ(other->escaped(outside, Vec3(-1, 0, 0)), Rgb(2.f));
}

TEST(PortalLight, ReachesLikeALampInThePortal) {
    const LightPtr light = makePortalLight(makeInfiniteLight(Transform(), Rgb(2.f)), kWindow);
    EXPECT_TRUE(light->isInfinite() && light->isAtInfinity() && !light->isDelta());
    const LightReach reach = light->reach();
    EXPECT_LT(length(reach.axis - Vec3(-1, 0, 0)), 1e-6f);
    EXPECT_EQ(reach.bounds.max, Vec3(1, 1, 1.6f));
    EXPECT_NEAR(light->power(7).x, 2 * kPi * 2.4f, 1e-2f);
    EXPECT_NEAR(reach.intensity, 2 * 2.4f, 1e-2f);
    // A black sky.
    const LightPtr black = makePortalLight(makeInfiniteLight(Transform(), Rgb(0.f)), kWindow);
    EXPECT_TRUE(isBlack(black->power(1)));
    EXPECT_FALSE(black->sample(Vec3(0, 0, 1), Vec2(0.3f, 0.4f)));
}

}  // namespace
}  // namespace drc
