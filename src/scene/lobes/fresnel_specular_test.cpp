#include "scene/lobes/fresnel_specular.h"

#include "scene/lobes/fresnel.h"
#include "scene/lobes/lobe_testing.h"

namespace drc {
namespace {

using namespace test;

TEST(FresnelSpecular, ChoosesByFresnel) {
    const FresnelSpecular lobe(Rgb(1.f), Rgb(1.f), 1, 1.5f);
    for (const float c : {0.9f, 0.1f, -0.9f}) {
        const float fresnel = fresnelDielectric(c, 1, 1.5f);
        const LobeSample r = lobe.sample(direction(c), 0.99f * fresnel, Vec2(0, 0), TransportMode::Radiance);
        EXPECT_EQ(r.flags, LobeFlags::Reflection | LobeFlags::Specular);
        EXPECT_NEAR(r.pdf, fresnel, 1e-6f);
        expectClose(r.f * (absCosTheta(r.wi) / r.pdf), Rgb(1.f), 1e-5f);
        const LobeSample t = lobe.sample(direction(c), 1.01f * fresnel, Vec2(0, 0), TransportMode::Radiance);
        EXPECT_EQ(t.flags, LobeFlags::Transmission | LobeFlags::Specular);
        EXPECT_NEAR(t.pdf, 1 - fresnel, 1e-6f);
        expectClose(t.f * (absCosTheta(t.wi) / t.pdf), Rgb(1 / (t.eta * t.eta)), 1e-5f);
    }
}

TEST(FresnelSpecular, TotalInternalReflectionReflects) {
    const FresnelSpecular lobe(Rgb(1.f), Rgb(1.f), 1, 1.5f);
    for (const float u : {0.f, 0.5f, kOneMinusEpsilon}) {
        const LobeSample s = lobe.sample(direction(-0.5f), u, Vec2(0, 0), TransportMode::Radiance);
        EXPECT_EQ(s.pdf, 1);
        EXPECT_GT(s.wi.z * -0.5f, 0);
    }
}

TEST(FresnelSpecular, ColoursAreUnbiased) {
    const FresnelSpecular lobe(Rgb(0.1f, 0.8f, 0.3f), Rgb(0.9f, 0.2f, 0.f), 1, 1.5f);
    for (const float c : {0.9f, 0.2f, -0.8f})
        expectClose(furnace(lobe, direction(c)), lobe.albedo(direction(c)), 0.03f);
    // If one branch has no light, no sample may be wasted on it.
    const FresnelSpecular clear(Rgb(0.f), Rgb(1.f), 1, 1.5f);
    EXPECT_EQ(clear.sample(direction(0.5f), 0, Vec2(0, 0), TransportMode::Radiance).pdf, 1);
}

}  // namespace
}  // namespace drc
