// view() must be the inverse of generateRay().
#include <gtest/gtest.h>

#include "scene/cameras/camera.h"

namespace drc {
namespace {

constexpr FilmGeometry kFilm{60, 40};

struct ViewCase {
    const char* name;
    std::shared_ptr<const Camera> camera;
};
void PrintTo(const ViewCase& c, std::ostream* out) { *out << c.name; }

std::vector<ViewCase> cases() {
    const Transform placed = Transform::lookAt(Vec3(1, 2, 3), Vec3(4, 2, 5), Vec3(0, 1, 0.2f));
    ProjectiveCameraParams still{.worldToCamera = placed, .fov = 60};
    ProjectiveCameraParams lens = still;
    lens.lensRadius = 0.3f;
    lens.focalDistance = 4;
    ProjectiveCameraParams scaled = lens;
    scaled.worldToCamera = Transform::scale(-2, 2, 2) * placed;
    ProjectiveCameraParams moving = lens;
    moving.worldToCamera = AnimatedTransform(placed, Transform::translate(Vec3(0.5f, 0.2f, 1)) * placed);
    return {
        {"Pinhole", makePerspectiveCamera(still, kFilm)},
        {"ThinLens", makePerspectiveCamera(lens, kFilm)},
        {"Scaled", makePerspectiveCamera(scaled, kFilm)},
        {"Moving", makePerspectiveCamera(moving, kFilm)},
        {"Orthographic", makeOrthographicCamera(still, kFilm)},
        {"OrthographicWithALens", makeOrthographicCamera(lens, kFilm)},
        {"OrthographicScaled", makeOrthographicCamera(scaled, kFilm)},
    };
}

class CameraView : public testing::TestWithParam<ViewCase> {};
INSTANTIATE_TEST_SUITE_P(Cameras, CameraView, testing::ValuesIn(cases()), [](const auto& i) { return i.param.name; });

TEST_P(CameraView, TurnsRaysBack) {
    const Camera& camera = *GetParam().camera;
    for (const Vec2& film : {Vec2(30, 20), Vec2(3, 7), Vec2(-2, 41), Vec2(59, 30)})
        for (const Vec2& uLens : {Vec2(0.5f, 0.5f), Vec2(0.1f, 0.8f)})
            for (const float distance : {0.7f, 6.f}) {
                constexpr float kTime = 0.3f;
                const Ray ray = camera.generateRay(film, uLens, kTime).ray;
                const Vec3 p = ray.o + ray.d * distance;
                const auto view = camera.view(p, uLens, ray.time);
                ASSERT_TRUE(view);
                EXPECT_NEAR(view->film.x, film.x, 2e-3);
                EXPECT_NEAR(view->film.y, film.y, 2e-3);
                EXPECT_LT(length(view->from - ray.o), 1e-4f);
                EXPECT_NEAR(view->pixelsPerArea / camera.pixelsPerArea(ray, distance), 1, 1e-3);
                // A small patch of a plane that faces the lens, with the corners where film positions project to.
                const Vec3 s = normalize(cross(ray.d, Vec3(0.3f, 1, 0.1f))), t = cross(ray.d, s);
                constexpr float kSide = 0.02f;
                const auto seen = [&](float a, float b) {
                    return camera.view(p + s * (a * kSide) + t * (b * kSide), uLens, ray.time)->film;
                };
                const Vec2 right = seen(1, 0), left = seen(-1, 0), above = seen(0, 1), below = seen(0, -1);
                const Vec2 x(right.x - left.x, right.y - left.y), y(above.x - below.x, above.y - below.y);
                const float pixels = std::abs(x.x * y.y - x.y * y.x);
                EXPECT_NEAR(pixels / (4 * kSide * kSide) / view->pixelsPerArea, 1, 0.01) << distance;
            }
}

TEST_P(CameraView, SeesNothingBehind) {
    const Camera& camera = *GetParam().camera;
    const Ray ray = camera.generateRay(Vec2(30, 20), Vec2(0.5f, 0.5f), 0).ray;
    EXPECT_FALSE(camera.view(ray.o - ray.d, Vec2(0.5f, 0.5f), ray.time));
}

TEST(CameraViews, SomeCannotTell) {
    const auto camera = makeEnvironmentCamera({}, kFilm);
    EXPECT_FALSE(camera->view(Vec3(1, 1, 1), Vec2(0.5f, 0.5f), 0));
    EXPECT_EQ(camera->pixelsPerArea(camera->generateRay(Vec2(30, 20), Vec2(0.5f, 0.5f), 0).ray, 1), 0);
    // A camera transform that scales axes unequally.
    const auto stretched = makePerspectiveCamera({.worldToCamera = Transform::scale(1, 2, 1)}, kFilm);
    EXPECT_FALSE(stretched->view(Vec3(0, 0, 1), Vec2(0.5f, 0.5f), 0));
}

}  // namespace
}  // namespace drc
