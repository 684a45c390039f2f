#include "scene/lobes/specular_transmission.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(SpecularTransmission, Refracts) {
    const SpecularTransmission lobe(Rgb(0.8f), 1, 1.5f);
    for (const float c : {0.95f, 0.2f, -0.9f}) {
        const Vec3 wo = direction(c);
        const LobeSample s = lobe.sample(wo, 0.3f, Vec2(0.2f, 0.4f), TransportMode::Radiance);
        const float eta = c > 0 ? 1.5f : 1 / 1.5f;
        ASSERT_GT(s.pdf, 0);
        EXPECT_NEAR(length(s.wi), 1, 1e-5f);
        EXPECT_LT(s.wi.z * wo.z, 0);
        // Snell: tangential parts are opposite and in the ratio of the indices.
        EXPECT_NEAR(s.wi.x * eta, -wo.x, 1e-6f);
        EXPECT_NEAR(s.wi.y * eta, -wo.y, 1e-6f);
        EXPECT_NEAR(s.eta, eta, 1e-6f);
        const Rgb weight = s.f * absCosTheta(s.wi);
        expectClose(weight, Rgb(0.8f * (1 - fresnelDielectric(c, 1, 1.5f)) / (eta * eta)), 1e-5f);
        const LobeSample back = lobe.sample(wo, 0.3f, Vec2(0.2f, 0.4f), TransportMode::Importance);
        expectClose(back.f * absCosTheta(back.wi), weight * (eta * eta), 1e-5f);
        // The way back is the same path.
        const LobeSample reverse = lobe.sample(s.wi, 0.3f, Vec2(0.2f, 0.4f), TransportMode::Radiance);
        EXPECT_LT(length(reverse.wi - wo), 1e-5f);
    }
}

TEST(SpecularTransmission, TotalInternalReflectionGivesNothing) {
    const SpecularTransmission lobe(Rgb(1.f), 1, 1.5f);
    EXPECT_EQ(lobe.sample(direction(-0.5f), 0, Vec2(0, 0), TransportMode::Radiance).pdf, 0);
}

TEST(SpecularTransmission, EqualIndicesPassStraightThrough) {
    const SpecularTransmission lobe(Rgb(0.3f), 1, 1);
    const Vec3 wo = direction(0.4f);
    const LobeSample s = lobe.sample(wo, 0, Vec2(0, 0), TransportMode::Radiance);
    EXPECT_LT(length(s.wi + wo), 1e-6f);
    expectClose(s.f * absCosTheta(s.wi), Rgb(0.3f), 1e-5f);
}

}  // namespace
}  // namespace drc
