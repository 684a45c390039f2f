#include "scene/lights/light_testing.h"

namespace drc {
namespace {

using test::checkPowerAndReach;
using test::intensityTowards;

TEST(GoniometricLight, LooksUpAsPbrt) {
    LightImage image{4, 2, {}};
    for (int i = 0; i < 8; ++i) image.texels.push_back(Rgb(float(i), 1, 0));
    const LightPtr light = makeGoniometricLight(Transform(), Rgb(2.f), image);
    // Centre of texel (1, 0): u = 1.5 / 4 from +x towards +z, a quarter of the way down from +y.
    const float phi = 0.75f * kPi, s = std::sqrt(0.5f);
    EXPECT_NEAR(intensityTowards(*light, Vec3(s * std::cos(phi), s, s * std::sin(phi))).x, 2 * 1, 1e-3);
    EXPECT_NEAR(intensityTowards(*light, Vec3(s * std::cos(phi), -s, s * std::sin(phi))).x, 2 * 5, 1e-3);
    // u = 0 is between the last column and the first. At the poles, rows must not be interpolated across to the other
    // pole.
    EXPECT_NEAR(intensityTowards(*light, Vec3(s, s, 0)).x, 2 * 1.5, 1e-3);
    EXPECT_NEAR(intensityTowards(*light, normalize(Vec3(std::cos(phi), 100, std::sin(phi)))).x, 2 * 1, 1e-3);
}

TEST(GoniometricLight, PowerAndReach) {
    LightImage image{32, 16, {}};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            image.texels.push_back(Rgb(1 + 0.5f * std::sin(x * kPi / 16), 1 + 0.05f * y, 0.2f + 0.01f * x));
    const Transform t = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(40, Vec3(3, 1, 2));
    checkPowerAndReach(*makeGoniometricLight(t, Rgb(3, 2, 1), image), 5e-3f);
    checkPowerAndReach(*makeGoniometricLight(t, Rgb(3, 2, 1), {}), 1e-4f);
}

TEST(GoniometricLight, BrokenTexelsAreBlack) {
    const LightPtr light = makeGoniometricLight(Transform(), Rgb(1.f), {1, 1, {Rgb(NAN, 1, 1)}});
    EXPECT_FALSE(light->sample(Vec3(0, 0, 1), Vec2(0, 0)));
    EXPECT_TRUE(isBlack(light->power(1)));
}

}  // namespace
}  // namespace drc
