#include "transport/environment_windows.h"

#include <gtest/gtest.h>

#include "math/rng.h"
#include "math/warp.h"
#include "scene/chi_square.h"
#include "scene/lobes/lobe_testing.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

using namespace test;

EnvironmentMap patches(int width, int height) {
    EnvironmentMap map{width, height, {}};
    std::mt19937 rng(9);
    for (int i = 0; i < width * height; ++i) map.texels.push_back(Rgb(0.1f + uniform(rng), 0.5f, uniform(rng)));
    return map;
}

// Two windows in one wall, and one in the ceiling that overlaps with them as seen from some points.
std::vector<Portal> windows() {
    const auto inWall = [](float y) {
        return Portal({Vec3(1, y, 0), Vec3(1, y, 1), Vec3(1, y + 1, 1), Vec3(1, y + 1, 0)});
    };
    return {inWall(-1.2f), inWall(0.3f),
            Portal({Vec3(-1, -1, 2), Vec3(-1, 1, 2), Vec3(1.6f, 1, 2), Vec3(1.6f, -1, 2)})};
}

struct Place {
    const char* name;
    Vec3 p;
};
const Place kPlaces[] = {{"inside", Vec3(0, 0, 0.5f)},
                         {"near a window", Vec3(0.9f, 0.6f, 0.2f)},
                         {"below", Vec3(-0.5f, -2, -1)},
                         {"behind one wall", Vec3(1.5f, 0.2f, 0.5f)},
                         {"outside of all", Vec3(2, 0, 3)}};

class WindowsOf : public testing::TestWithParam<bool> {
  protected:
    const LightPtr sky = GetParam() ? makeInfiniteLight(Transform::rotate(70, Vec3(1, 2, 3)), Rgb(1.f), patches(16, 8))
                                    : makeInfiniteLight(Transform(), Rgb(2.f));
    const EnvironmentWindows all{*sky, windows()};
};
INSTANTIATE_TEST_SUITE_P(Skies, WindowsOf, testing::Bool(), [](const auto& i) { return i.param ? "Map" : "Constant"; });

TEST_P(WindowsOf, DirectionsFollowTheDensity) {
    EXPECT_EQ(all.count(), 3U);
    for (const Place& place : kPlaces) {
        const auto sample = [&](std::mt19937& rng) -> std::optional<Vec3> {
            const auto s = all.sample(place.p, uniform2(rng));
            if (!s) return std::nullopt;
            return s->wi;
        };
        const ChiSquare r = chiSquareTest(
            sample, [&](const Vec3& w) { return all.inverse(place.p, w).pdf; }, 40000, 8, 1e-6);
        EXPECT_GT(r.pValue, kChiSquareLevel) << place.name << " chi2 " << r.statistic << " dof " << r.degreesOfFreedom;
        EXPECT_GT(r.degreesOfFreedom, 100);
        // Less where a direction belongs to another window, or to one instead of the whole sky.
        EXPECT_LT(r.pdfIntegral, 1.005);
        EXPECT_GT(r.pdfIntegral, 0.7);
    }
}

// No direction is lost, and each goes back to its random number.
TEST_P(WindowsOf, GiveAllLight) {
    for (const Place& place : kPlaces) {
        Pcg32 rng(3);
        RunningMean bySample[4], byDirection[4];
        int different = 0;
        constexpr int kSamples = 40000;
        for (int i = 0; i < kSamples; ++i) {
            const Vec2 u = rng.nextVec2();
            const auto s = all.sample(place.p, u);
            for (int k = 0; k < 4; ++k)
                bySample[k].add(s ? sky->escaped(place.p, s->wi).x / s->pdf * (k < 3 ? 1 + double(s->wi[k]) : 1.0)
                                  : 0.0);
            if (s) {
                const auto back = all.inverse(place.p, s->wi);
                different += std::abs(back.pdf - s->pdf) > 1e-2f * s->pdf || (back.u - u).length() > 5e-3f;
                EXPECT_EQ(s->distance, kInfinity);
            }
            const Vec3 w = sampleUniformSphere(rng.nextVec2());
            EXPECT_GT(all.inverse(place.p, w).pdf, 0);
            for (int k = 0; k < 4; ++k)
                byDirection[k].add(sky->escaped(place.p, w).x * 4 * kPi * (k < 3 ? 1 + double(w[k]) : 1.0));
        }
        EXPECT_LT(different, kSamples / 400) << place.name;
        for (int k = 0; k < 4; ++k) expectSame(bySample[k], byDirection[k], 1e-4, place.name);
    }
}

TEST_P(WindowsOf, WithoutAnyAreTheEnvironment) {
    const EnvironmentWindows none(*sky);
    Pcg32 rng(4);
    for (int i = 0; i < 100; ++i) {
        const Vec2 u = rng.nextVec2();
        const auto a = none.sample(Vec3(1, 2, 3), u), b = sky->sample(Vec3(1, 2, 3), u);
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->wi, b->wi);
        EXPECT_EQ(a->pdf, b->pdf);
        const auto back = none.inverse(Vec3(1, 2, 3), a->wi);
        EXPECT_EQ(back.pdf, sky->pdfEscaped(Vec3(1, 2, 3), a->wi));
        EXPECT_EQ(back.u, sky->inverse(Vec3(1, 2, 3), a->wi));
    }
    // From outside, windows have no share.
    EXPECT_EQ(all.sample(Vec3(2, 0, 3), Vec2(0.3f, 0.4f))->pdf, sky->sample(Vec3(2, 0, 3), Vec2(0.3f, 0.4f))->pdf);
}

TEST(EnvironmentWindows, MostSamplesGoThroughThem) {
    const LightPtr sky = makeInfiniteLight(Transform(), Rgb(2.f));
    const Portal small({Vec3(1, 0, 0), Vec3(1, 0, 0.2f), Vec3(1, 0.2f, 0.2f), Vec3(1, 0.2f, 0)});
    const EnvironmentWindows windows(*sky, {small});
    Pcg32 rng(4);
    int passed = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto s = windows.sample(Vec3(-1, 0, 0), rng.nextVec2());
        passed += s && small.isPassed(Vec3(-1, 0, 0), s->wi);
    }
    EXPECT_NEAR(passed, 750, 60);
    // More than there is room for: the first count.
    EXPECT_EQ(EnvironmentWindows(*sky, std::vector<Portal>(20, small)).count(), EnvironmentWindows::kMost);
}

}  // namespace
}  // namespace drc
