#include "scene/lights/emission_profile.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

const Vec3 kNormal = normalize(Vec3(1, 2, -2));

Vec3 towards(float degrees) {
    const Vec3 across = normalize(cross(kNormal, Vec3(0, 0, 1)));
    const float angle = degrees * kPi / 180;
    return kNormal * std::cos(angle) + across * std::sin(angle);
}

TEST(EmissionProfile, IsEvenByDefault) {
    for (const EmissionProfile& even : {EmissionProfile(), EmissionProfile::narrowed(180)}) {
        EXPECT_TRUE(even.isEven());
        EXPECT_EQ(even.share(kNormal, towards(80)), 1);
        EXPECT_EQ(even.power(), 1);
        EXPECT_EQ(even.sinReach(), 1);
    }
}

class NarrowedEmission : public testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(, NarrowedEmission, testing::Values(0.01f, 0.1f, 1.f, 20.f, 90.f, 170.f, 179.f));

TEST_P(NarrowedEmission, HasAnEdgeAndKeepsThePower) {
    const float degrees = GetParam();
    const EmissionProfile narrow = EmissionProfile::narrowed(degrees);
    EXPECT_FALSE(narrow.isEven());
    EXPECT_NEAR(narrow.sinReach(), std::sin(degrees * kPi / 360), 1e-6);
    EXPECT_EQ(narrow.share(kNormal, towards(degrees / 2 + 0.1f)), 0);
    EXPECT_GT(narrow.share(kNormal, kNormal), 1);
    // Two-sided emitters shine to both sides alike.
    EXPECT_EQ(narrow.share(kNormal, -kNormal), narrow.share(kNormal, kNormal));
    if (degrees < 1) return;  // directions are not fine enough
    // At a quarter of the angle, by the tangents.
    const double half = double(degrees) * M_PI / 360;
    EXPECT_NEAR(narrow.share(kNormal, towards(degrees / 4)) / narrow.share(kNormal, kNormal),
                1 - std::tan(half / 2) / std::tan(half), 2e-3);
    // The integral over the hemisphere, of the cosine times the share, is pi.
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double angle = half * (i + 0.5) / kSteps;
        sum += double(narrow.share(kNormal, towards(float(angle * 180 / M_PI)))) * std::cos(angle) * std::sin(angle) *
               2 * M_PI * half / kSteps;
    }
    EXPECT_NEAR(sum / M_PI, 1, 2e-3);
}

TEST(EmissionProfile, OfASpotIsAroundItsAxis) {
    const Vec3 axis(0, 0, 1);
    const SpotFalloff falloff(40, 15, SpotEdge::Smooth);
    const EmissionProfile spot({axis, falloff});
    EXPECT_FALSE(spot.isEven());
    for (const float degrees : {0.f, 20.f, 30.f, 39.f, 41.f, 100.f}) {
        const float angle = degrees * kPi / 180;
        EXPECT_EQ(spot.share(kNormal, Vec3(std::sin(angle), 0, std::cos(angle))), falloff.at(std::cos(angle)));
    }
    EXPECT_FLOAT_EQ(spot.power(), falloff.solidAngle() / (4 * kPi));
    EXPECT_EQ(spot.sinReach(), 1);
}

}  // namespace
}  // namespace drc
