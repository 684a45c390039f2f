#include "scene/lights/light_testing.h"

namespace drc {
namespace {

using test::checkPowerAndReach;
using test::intensityTowards;

LightImage gradient(int width, int height) {
    LightImage image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.texels.push_back(Rgb(float(x), float(y), 1));
    return image;
}

TEST(ProjectionLight, ThePictureFillsTheFieldOfView) {
    // Twice as wide as high: at 90 degrees it covers [-2,2] x [-1,1] of the plane z = 1, row 0 lowest.
    const LightPtr light = makeProjectionLight(Transform(), Rgb(2.f), 90, gradient(4, 2));
    const auto at = [&](float x, float y) { return intensityTowards(*light, normalize(Vec3(x, y, 1))); };
    EXPECT_NEAR(at(-1.5f, -0.5f).x, 0, 1e-4);
    EXPECT_NEAR(at(1.5f, -0.5f).x, 2 * 3, 1e-4);
    EXPECT_NEAR(at(1.5f, -0.5f).y, 0, 1e-4);
    EXPECT_NEAR(at(1.5f, 0.5f).y, 2 * 1, 1e-4);
    EXPECT_NEAR(at(0, 0).x, 2 * 1.5f, 1e-4);
    EXPECT_NEAR(at(1.99f, 0.99f).z, 2, 1e-4);
    EXPECT_TRUE(isBlack(at(2.01f, 0)));
    EXPECT_TRUE(isBlack(at(0, -1.01f)));
    EXPECT_TRUE(isBlack(intensityTowards(*light, Vec3(0, 0, -1))));
    // For an upright image the field of view applies to its width.
    const LightPtr high = makeProjectionLight(Transform(), Rgb(1.f), 90, gradient(2, 4));
    EXPECT_FALSE(isBlack(intensityTowards(*high, normalize(Vec3(0.99f, 1.99f, 1)))));
    EXPECT_TRUE(isBlack(intensityTowards(*high, normalize(Vec3(1.01f, 0, 1)))));
}

TEST(ProjectionLight, PowerAndReach) {
    const Transform t = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(70, Vec3(1, 2, 3));
    checkPowerAndReach(*makeProjectionLight(t, Rgb(3, 2, 1), 60, {}), 1e-2f);
    checkPowerAndReach(*makeProjectionLight(t, Rgb(3, 2, 1), 90, gradient(16, 8)), 1e-2f);
    checkPowerAndReach(*makeProjectionLight(Transform::scale(-3, 3, 3), Rgb(1.f), 120, gradient(8, 24)), 1e-2f);
}

}  // namespace
}  // namespace drc
