#include <gtest/gtest.h>

#include "scene/cameras/camera.h"

namespace drc {
namespace {

Ray rayAt(const Camera& camera, float x, float y) { return camera.generateRay(Vec2(x, y), Vec2(0, 0), 0.5f).ray; }

TEST(EnvironmentCamera, LatitudesAndLongitudes) {
    const auto camera = makeEnvironmentCamera({}, {400, 200});
    const auto expectAlong = [&](float x, float y, const Vec3& d) {
        EXPECT_LT(length(rayAt(*camera, x, y).d - d), 1e-5f) << x << " " << y;
    };
    expectAlong(0, 100, Vec3(1, 0, 0));
    expectAlong(100, 100, Vec3(0, 0, 1));
    expectAlong(200, 100, Vec3(-1, 0, 0));
    expectAlong(300, 100, Vec3(0, 0, -1));
    expectAlong(77, 0, Vec3(0, 1, 0));
    expectAlong(77, 200, Vec3(0, -1, 0));
    EXPECT_EQ(rayAt(*camera, 1, 1).time, 0.5f);
}

TEST(EnvironmentCamera, StandsWhereItIsPut) {
    EnvironmentCameraParams p;
    p.worldToCamera = Transform::lookAt(Vec3(1, 2, 3), Vec3(1, 2, 0), Vec3(0, 1, 0));
    const auto camera = makeEnvironmentCamera(p, {400, 200})->withFilm({40, 20});
    EXPECT_LT(length(rayAt(*camera, 10, 10).d - Vec3(0, 0, -1)), 1e-5f);
    EXPECT_LT(length(rayAt(*camera, 10, 10).o - Vec3(1, 2, 3)), 1e-5f);
    EXPECT_LT(length(camera->up() - Vec3(0, 1, 0)), 1e-5f);
}

TEST(EnvironmentCamera, ConesShareTheSphere) {
    const FilmGeometry film{64, 32};
    const auto camera = makeEnvironmentCamera({}, film);
    double sum = 0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) sum += sqr(rayAt(*camera, float(x) + 0.5f, float(y) + 0.5f).coneSpread);
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 0.01);
    EXPECT_GT(rayAt(*camera, 1, 0).coneSpread, 0);
}

}  // namespace
}  // namespace drc
