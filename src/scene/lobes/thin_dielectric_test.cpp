#include "scene/lobes/thin_dielectric.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(ThinDielectric, SumsTheReflectionsWithin) {
    const ThinDielectric lobe(1.5f);
    EXPECT_NEAR(lobe.reflectance(1), 0.08f / 1.04f, 1e-6f);
    for (const float c : {0.9f, 0.4f, -0.1f}) {
        const float r = fresnelDielectric(std::abs(c), 1, 1.5f);
        double sum = r, through = sqr(1 - r);
        for (int i = 0; i < 200; ++i, through *= r * r) sum += through * r;
        EXPECT_NEAR(lobe.reflectance(c), sum, 1e-5);
    }
}

TEST(ThinDielectric, GoesStraightThrough) {
    const ThinDielectric lobe(1.5f);
    for (const float c : {0.9f, 0.2f, -0.5f}) {
        const Vec3 wo = direction(c);
        const float r = lobe.reflectance(c);
        const LobeSample reflected = lobe.sample(wo, 0.99f * r, Vec2(0, 0), TransportMode::Radiance);
        EXPECT_EQ(reflected.wi, Vec3(-wo.x, -wo.y, wo.z));
        EXPECT_EQ(reflected.flags, LobeFlags::Reflection | LobeFlags::Specular);
        const LobeSample passed = lobe.sample(wo, 1.01f * r, Vec2(0, 0), TransportMode::Radiance);
        EXPECT_EQ(passed.wi, -wo);
        EXPECT_EQ(passed.eta, 1);
        EXPECT_EQ(passed.flags, LobeFlags::Transmission | LobeFlags::Specular);
        EXPECT_NEAR(passed.pdf, 1 - r, 1e-6f);
        expectClose(furnace(lobe, wo, 1000), Rgb(1.f), 1e-4f);
    }
}

}  // namespace
}  // namespace drc
