#include <gtest/gtest.h>

#include "scene/cameras/camera.h"

namespace drc {
namespace {

void expectNear(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

Ray rayAt(const Camera& camera, float x, float y, const Vec2& uLens = Vec2(0.5f, 0.5f)) {
    const CameraRay r = camera.generateRay(Vec2(x, y), uLens, 0);
    EXPECT_EQ(r.weight, 1);
    return r.ray;
}

TEST(OrthographicCamera, ParallelRaysFromTheScreenWindow) {
    const auto camera = makeOrthographicCamera({}, {200, 100});
    expectNear(rayAt(*camera, 0, 0).o, Vec3(-2, 1, 0));
    expectNear(rayAt(*camera, 200, 100).o, Vec3(2, -1, 0));
    expectNear(rayAt(*camera, 13, 70).d, Vec3(0, 0, 1));
    ProjectiveCameraParams p;
    p.worldToCamera = Transform::lookAt(Vec3(0, 0, 5), Vec3(0, 0, 0), Vec3(0, 1, 0));
    p.hasScreenWindow = true;
    const float window[4] = {-3, 1, -2, 2};
    std::copy(window, window + 4, p.screenWindow);
    const auto other = makeOrthographicCamera(p, {100, 100});
    expectNear(rayAt(*other, 0, 0).o, Vec3(3, 2, 5));
    expectNear(rayAt(*other, 0, 0).d, Vec3(0, 0, -1));
    expectNear(other->withFilm({400, 10})->position(), Vec3(0, 0, 5));
}

TEST(OrthographicCamera, ConeIsAPixelWideEverywhere) {
    ProjectiveCameraParams p;
    p.worldToCamera = Transform::scale(0.5f, 0.5f, 0.5f);  // a world unit is half a unit of camera space
    const Ray r = rayAt(*makeOrthographicCamera(p, {100, 100}), 3, 5);
    EXPECT_NEAR(r.coneWidth, 0.04f, 1e-6);
    EXPECT_EQ(r.coneSpread, 0);
}

TEST(OrthographicCamera, ThinLensFocusesAtItsDistance) {
    ProjectiveCameraParams p;
    p.lensRadius = 0.3f;
    p.focalDistance = 4;
    const auto camera = makeOrthographicCamera(p, {100, 100});
    const Vec3 start = rayAt(*makeOrthographicCamera({}, {100, 100}), 20, 90).o;
    float widest = 0;
    for (const Vec2& u : {Vec2(0.1f, 0.2f), Vec2(0.9f, 0.5f), Vec2(1, 0.5f), Vec2(1, 1)}) {
        const Ray r = rayAt(*camera, 20, 90, u);
        expectNear(r.o + r.d * (4 / r.d.z), start + Vec3(0, 0, 4), 1e-5f);
        widest = std::max(widest, length(r.o - start));
    }
    EXPECT_NEAR(widest, 0.3f, 1e-5);
}

TEST(OrthographicCamera, Shutter) {
    ProjectiveCameraParams p;
    p.shutter = {2, 6, 1, 5};
    EXPECT_EQ(makeOrthographicCamera(p, {10, 10})->generateRay(Vec2(5, 5), Vec2(0, 0), 0.25f).ray.time, 0.5f);
}

}  // namespace
}  // namespace drc
