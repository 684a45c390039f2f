#include "scene/lobes/specular_reflection.h"

#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(SpecularReflection, Mirrors) {
    const SpecularReflection lobe(Rgb(0.9f, 0.5f, 0.1f), Fresnel::none());
    for (const float c : {0.9f, 0.1f, -0.5f}) {
        const Vec3 wo = direction(c);
        const LobeSample s = lobe.sample(wo, 0.3f, Vec2(0.2f, 0.4f), TransportMode::Radiance);
        EXPECT_EQ(s.wi, Vec3(-wo.x, -wo.y, wo.z));
        EXPECT_EQ(s.pdf, 1);
        EXPECT_EQ(s.eta, 1);
        EXPECT_EQ(s.flags, LobeFlags::Reflection | LobeFlags::Specular);
        expectClose(s.f * absCosTheta(s.wi), Rgb(0.9f, 0.5f, 0.1f), 1e-6f);
        EXPECT_TRUE(isBlack(lobe.f(wo, s.wi)));
        EXPECT_EQ(lobe.pdf(wo, s.wi), 0);
    }
}

TEST(SpecularReflection, Fresnel) {
    const SpecularReflection lobe(Rgb(1.f), Fresnel::dielectric(1, 1.5f));
    EXPECT_NEAR(furnace(lobe, Vec3(0, 0, 1), 1).x, 0.04f, 1e-6f);
    EXPECT_NEAR(furnace(lobe, direction(-0.5f), 1).x, 1, 1e-6f);  // total internal reflection
}

}  // namespace
}  // namespace drc
