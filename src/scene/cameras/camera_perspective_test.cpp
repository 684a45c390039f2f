#include <gtest/gtest.h>

#include "scene/cameras/camera.h"

namespace drc {
namespace {

void expectNear(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

Vec3 directionAt(const Camera& camera, float x, float y) {
    const Ray r = camera.generateRay(Vec2(x, y), Vec2(0.5f, 0.5f), 0).ray;
    EXPECT_NEAR(length(r.d), 1, 1e-6);
    return r.d;
}

TEST(PerspectiveCamera, CornersOfAWideFilm) {
    // fov 90 is that of the shorter axis, so the screen is [-2,2] x [-1,1] at z = 1.
    const auto camera = makePerspectiveCamera({}, {200, 100});
    expectNear(directionAt(*camera, 0, 0), normalize(Vec3(-2, 1, 1)));
    expectNear(directionAt(*camera, 200, 0), normalize(Vec3(2, 1, 1)));
    expectNear(directionAt(*camera, 200, 100), normalize(Vec3(2, -1, 1)));
    expectNear(directionAt(*camera, 100, 50), Vec3(0, 0, 1));
    expectNear(directionAt(*camera, 100.5f, 50), normalize(Vec3(0.01f, 0, 1)));
}

TEST(PerspectiveCamera, CornersOfATallFilm) {
    const auto camera = makePerspectiveCamera({.worldToCamera = Transform(), .fov = 60}, {100, 200});
    const float t = 0.57735027f;
    expectNear(directionAt(*camera, 0, 0), normalize(Vec3(-t, 2 * t, 1)));
    expectNear(directionAt(*camera, 100, 200), normalize(Vec3(t, -2 * t, 1)));
}

TEST(PerspectiveCamera, LookAtIsLeftHanded) {
    ProjectiveCameraParams p;
    p.worldToCamera = Transform::lookAt(Vec3(0, 0, 5), Vec3(0, 0, 0), Vec3(0, 1, 0));
    const auto camera = makePerspectiveCamera(p, {100, 100});
    expectNear(camera->position(), Vec3(0, 0, 5));
    expectNear(camera->up(), Vec3(0, 1, 0));
    // When looking along -z, pbrt has world -x on the right.
    expectNear(directionAt(*camera, 100, 50), normalize(Vec3(-1, 0, -1)));
    expectNear(directionAt(*camera, 50, 0), normalize(Vec3(0, 1, -1)));
    // Scale(-1, 1, 1) before LookAt, the usual remedy, mirrors the image.
    p.worldToCamera = Transform::scale(-1, 1, 1) * p.worldToCamera;
    expectNear(directionAt(*makePerspectiveCamera(p, {100, 100}), 100, 50), normalize(Vec3(1, 0, -1)));
}

TEST(PerspectiveCamera, FrameAspectAndScreenWindow) {
    // A frame of aspect ratio 4:1 stretched to a square film.
    expectNear(
        directionAt(*makePerspectiveCamera({.worldToCamera = Transform(), .frameAspectRatio = 4}, {100, 100}), 0, 0),
        normalize(Vec3(-4, 1, 1)));
    ProjectiveCameraParams p;
    p.hasScreenWindow = true;
    const float window[4] = {-0.5f, 1, -2, 0.25f};
    std::copy(window, window + 4, p.screenWindow);
    const auto camera = makePerspectiveCamera(p, {300, 100});
    expectNear(directionAt(*camera, 0, 0), normalize(Vec3(-0.5f, 0.25f, 1)));
    expectNear(directionAt(*camera, 300, 100), normalize(Vec3(1, -2, 1)));
}

TEST(PerspectiveCamera, WithFilmAppliesTheRuleAnew) {
    const auto wide = makePerspectiveCamera({}, {200, 100});
    const auto tall = wide->withFilm({100, 200});
    expectNear(directionAt(*tall, 0, 0), normalize(Vec3(-1, 2, 1)));
    expectNear(directionAt(*wide->withFilm({400, 200}), 0, 0), directionAt(*wide, 0, 0));
}

TEST(PerspectiveCamera, ConeCoversThePixel) {
    const auto camera = makePerspectiveCamera({}, {1000, 1000});
    const Ray centre = camera->generateRay(Vec2(500, 500), Vec2(0, 0), 0).ray;
    EXPECT_NEAR(centre.coneSpread, 0.002, 1e-8);
    EXPECT_EQ(centre.coneWidth, 0);
    // Towards a corner: the solid angle between four neighbouring rays.
    const Vec3 a = directionAt(*camera, 0, 0), b = directionAt(*camera, 1, 0), c = directionAt(*camera, 0, 1);
    const Ray corner = camera->generateRay(Vec2(0.5f, 0.5f), Vec2(0, 0), 0).ray;
    EXPECT_NEAR(sqr(corner.coneSpread) / length(cross(b - a, c - a)), 1, 2e-2);
}

TEST(PerspectiveCamera, ThinLensFocuses) {
    ProjectiveCameraParams p;
    p.worldToCamera = Transform::lookAt(Vec3(1, 2, 3), Vec3(4, 0, 1), Vec3(0, 0, 1));
    p.lensRadius = 0.2f;
    p.focalDistance = 5;
    const auto camera = makePerspectiveCamera(p, {160, 90});
    p.lensRadius = 0;
    const auto pinhole = makePerspectiveCamera(p, {160, 90});
    const Vec2 film(20, 70);
    const Vec3 forward = directionAt(*pinhole, 80, 45), d = directionAt(*pinhole, film.x, film.y);
    // All rays of a film position start on a disk and meet on the plane at the focal distance.
    const Vec3 focus = pinhole->position() + d * (5 / dot(d, forward));
    for (const Vec2& u : {Vec2(0.1f, 0.2f), Vec2(0.9f, 0.5f), Vec2(0.5f, 0.5f), Vec2(1, 1)}) {
        const Ray r = camera->generateRay(film, u, 0).ray;
        expectNear(r.o + r.d * dot(focus - r.o, r.d), focus, 1e-4f);
        EXPECT_LE(length(r.o - camera->position()), 0.2f + 1e-5f);
        EXPECT_NEAR(dot(r.o - camera->position(), forward), 0, 1e-5);
    }
    // pbrt's very large default focal distance must not overflow.
    p.lensRadius = 0.2f;
    p.focalDistance = 1e30f;
    expectNear(directionAt(*makePerspectiveCamera(p, {160, 90}), film.x, film.y), d);
}

TEST(PerspectiveCamera, Shutter) {
    const auto camera = makePerspectiveCamera({.worldToCamera = Transform(), .shutter = {2, 6, 1, 5}}, {10, 10});
    EXPECT_EQ(camera->generateRay(Vec2(5, 5), Vec2(0, 0), 0.25f).ray.time, 0.5f);
}

}  // namespace
}  // namespace drc
