#include "scene/lights/light_testing.h"

namespace drc {
namespace {

using test::checkPowerAndReach;
using test::intensityTowards;

Vec3 offAxis(float degrees) { return Vec3(std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180)); }

TEST(SpotLight, FullInsideFadesAtTheEdgeAndEnds) {
    const LightPtr light = makeSpotLight(Transform(), Rgb(4, 2, 1), {30, 10});
    EXPECT_NEAR(intensityTowards(*light, offAxis(0)).x, 4, 1e-4);
    EXPECT_NEAR(intensityTowards(*light, offAxis(19.9f)).x, 4, 1e-4);
    // Where the cosine is halfway between those of 20 and 30 degrees, the falloff is (1/2)^4.
    const float half = 0.5f * (std::cos(kPi / 9) + std::cos(kPi / 6));
    EXPECT_NEAR(intensityTowards(*light, offAxis(std::acos(half) * 180 / kPi)).y, 2 / 16.f, 1e-4);
    EXPECT_TRUE(isBlack(intensityTowards(*light, offAxis(30.1f))));
    EXPECT_TRUE(isBlack(intensityTowards(*light, Vec3(0, 0, -1))));
    EXPECT_FALSE(light->sample(Vec3(0, 0, 0), Vec2(0, 0)));
}

TEST(SpotLight, PowerAndReach) {
    checkPowerAndReach(*makeSpotLight(Transform(), Rgb(3, 2, 1), {30, 5}), 5e-3f);
    checkPowerAndReach(*makeSpotLight(Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(70, Vec3(1, 2, 3)),
                                      Rgb(3, 2, 1), {60, 60}),
                       5e-3f);
    // A cone wider than a hemisphere, and one without a soft edge.
    checkPowerAndReach(*makeSpotLight(Transform::scale(2, 2, -2), Rgb(1.f), {120, 20}), 5e-3f);
    checkPowerAndReach(*makeSpotLight(Transform(), Rgb(1.f), {45, 0}), 1e-2f);
}

TEST(SpotLight, SmoothEdge) {
    const LightPtr light = makeSpotLight(Transform(), Rgb(4, 2, 1), {30, 10, SpotEdge::Smooth});
    const float edge = std::cos(kPi / 6), full = std::cos(kPi / 9);
    const auto at = [&](float x) {  // at a share of the way from the cosine of the edge to that of full intensity
        return intensityTowards(*light, offAxis(std::acos(edge + x * (full - edge)) * 180 / kPi)).x;
    };
    EXPECT_NEAR(at(0.5f), 2, 1e-3);
    EXPECT_NEAR(at(0.25f), 4 * 0.15625f, 1e-3);
    EXPECT_NEAR(at(1), 4, 1e-3);
    checkPowerAndReach(*light, 5e-3f);
}

TEST(SpotLight, ShinesAlongItsOwnAxis) {
    const Transform t = Transform::translate(Vec3(5, 0, 0)) * Transform::rotate(90, Vec3(0, 1, 0));
    const LightPtr light = makeSpotLight(t, Rgb(1.f), {20, 0});
    EXPECT_TRUE(light->sample(Vec3(8, 0, 0), Vec2(0, 0)));
    EXPECT_FALSE(light->sample(Vec3(5, 0, 3), Vec2(0, 0)));
    EXPECT_LT(length(light->reach().axis - Vec3(1, 0, 0)), 1e-6f);
    // A non-uniform scale distorts the cone, so reach() must include all directions.
    const LightPtr wide = makeSpotLight(Transform::scale(10, 1, 1), Rgb(1.f), {45, 0});
    EXPECT_TRUE(wide->sample(Vec3(5, 0, 1), Vec2(0, 0)));
    EXPECT_EQ(wide->reach().spread, kPi);
}

}  // namespace
}  // namespace drc
