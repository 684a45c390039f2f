#include <gtest/gtest.h>

#include "math/rng.h"
#include "scene/cameras/camera.h"
#include "scene/cameras/lens_system.h"
#include "scene/shapes/shape_check.h"

namespace drc {
namespace {

RealisticCameraParams camera50mm(float stop) {
    RealisticCameraParams p;
    p.lens = {{0.05f, 0.006f, 1.5f, 0.015f}, {-0.05f, 0.003f, 1, 0.015f}, {0, 0.045f, 0, stop}};
    p.focusDistance = 3;
    return p;
}

TEST(RealisticCamera, SeesWhatAPinholeWouldSee) {
    const RealisticCameraParams p = camera50mm(0.0005f);
    const FilmGeometry film{360, 240, 43.27f};  // 36 x 24 mm
    const auto camera = makeRealisticCamera(p, film);
    LensSystem lens(p.lens);
    lens.focus(3);
    const LensSystem::Cardinal c = lens.cardinal();
    const float size = 0.036f / c.rear * (3 - c.front);  // width of the field of view at the focus distance
    const auto at = [&](float x, float y) {
        const CameraRay r = camera->generateRay(Vec2(x, y), Vec2(0.5f, 0.5f), 0);
        EXPECT_GT(r.weight, 0);
        EXPECT_NEAR(length(r.ray.d), 1, 1e-5);
        return r.ray.o + r.ray.d * ((3 - r.ray.o.z) / r.ray.d.z);
    };
    EXPECT_LT(length(at(180, 120) - Vec3(0, 0, 3)), 1e-3f);
    // Right and up in the image are right and up in the scene: the image is not mirrored.
    EXPECT_NEAR(at(216, 120).x / (0.1f * size), 1, 0.02);
    EXPECT_NEAR(at(216, 120).y, 0, 1e-3);
    EXPECT_NEAR(at(180, 84).y / (0.1f * size), 1, 0.02);
    // The cone's width at the focus distance is that of a pixel.
    const Ray ray = camera->generateRay(Vec2(180, 120), Vec2(0.5f, 0.5f), 0).ray;
    EXPECT_NEAR(ray.coneSpread * (3 - c.front) / (size / 360), 1, 0.01);
}

TEST(RealisticCamera, FocusesWithAnOpenStop) {
    RealisticCameraParams p = camera50mm(0.003f);
    p.worldToCamera = Transform::lookAt(Vec3(1, 2, 3), Vec3(1, 2, 10), Vec3(0, 1, 0));
    const auto camera = makeRealisticCamera(p, {100, 100, 20});
    Pcg32 rng(1);
    float sharp = 0, blurred = 0;
    for (int i = 0; i < 200; ++i) {
        const CameraRay r = camera->generateRay(Vec2(50, 50), rng.nextVec2(), 0);
        if (!(r.weight > 0)) continue;
        const auto off = [&](float distance) {
            const Vec3 at = r.ray.o + r.ray.d * ((3 + distance - r.ray.o.z) / r.ray.d.z) - Vec3(1, 2, 3 + distance);
            return std::max(std::abs(at.x), std::abs(at.y));
        };
        sharp = std::max(sharp, off(3));
        blurred = std::max(blurred, off(30));
    }
    EXPECT_LT(sharp, 0.003f);
    EXPECT_GT(blurred, 0.015f) << "nine times the stop's radius";
}

// Irradiance at film points from a uniform environment must be the same when rays are aimed at the pupil's box and at
// the whole rear plane.
void checkPupils(std::vector<LensElement> elements, float half) {
    RealisticCameraParams p;
    p.lens = std::move(elements);
    p.focusDistance = 3;
    p.simpleWeighting = false;
    p.shutter = {1, 3};
    const auto camera = makeRealisticCamera(p, {100, 100, 40});
    LensSystem lens(p.lens);
    lens.focus(p.focusDistance);
    for (const Vec2& at : {Vec2(50, 50), Vec2(20, 60), Vec2(3, 2), Vec2(50, 99)}) {
        Pcg32 rng(7);
        RunningMean byCamera, byPlane;
        // Where generateRay puts the film point.
        const float side = 0.04f / std::sqrt(2.f);
        const Vec3 o(-(at.x / 100 - 0.5f) * side, (at.y / 100 - 0.5f) * side, 0);
        int lost = 0;
        for (int i = 0; i < 20000; ++i) {
            const float weight = camera->generateRay(at, rng.nextVec2(), 0).weight;
            byCamera.add(weight);
            lost += !(weight > 0);
            const Vec2 u = rng.nextVec2();
            const Vec3 d = Vec3((2 * u.x - 1) * half, (2 * u.y - 1) * half, lens.rearZ()) - o;
            const float cosine = d.z / length(d);
            byPlane.add(lens.trace({o, d}) ? 2 * sqr(sqr(cosine)) * sqr(2 * half) / sqr(lens.rearZ()) : 0);
        }
        EXPECT_GT(byPlane.mean(), 0);
        expectSame(byCamera, byPlane, 1e-6, "irradiance");
        if (at == Vec2(50, 50)) {
            EXPECT_LT(lost, 20000 * 0.4);
        }
    }
}

TEST(RealisticCamera, PupilsMissNothing) {
    checkPupils(camera50mm(0.001f).lens, 0.002f);
    checkPupils(camera50mm(0.008f).lens, 0.015f);
    // With the stop in front of the glass, each film point has a different pupil, with a clipped rim.
    checkPupils({{0, 0.012f, 0, 0.004f}, {0.05f, 0.006f, 1.5f, 0.01f}, {-0.05f, 0.045f, 1, 0.01f}}, 0.015f);
}

TEST(RealisticCamera, SimpleWeightsAreOneInTheMiddle) {
    const auto camera = makeRealisticCamera(camera50mm(0.004f), {100, 100, 40});
    Pcg32 rng(3);
    RunningMean middle, corner;
    for (int i = 0; i < 4000; ++i) {
        const float weight = camera->generateRay(Vec2(50, 50), rng.nextVec2(), 0).weight;
        if (weight > 0) middle.add(weight);
        corner.add(camera->generateRay(Vec2(1, 1), rng.nextVec2(), 0).weight);
    }
    EXPECT_NEAR(middle.mean(), 1, 0.02);
    EXPECT_LT(corner.mean(), 0.7);
}

}  // namespace
}  // namespace drc
