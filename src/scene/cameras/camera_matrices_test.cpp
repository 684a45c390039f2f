#include "scene/cameras/camera_matrices.h"

#include <gtest/gtest.h>

namespace drc {
namespace {

constexpr FilmGeometry kFilm{60, 40};
const Transform kPlaced = Transform::lookAt(Vec3(1, 2, 3), Vec3(4, 2, 5), Vec3(0, 1, 0.2f));

struct Case {
    const char* name;
    std::shared_ptr<const Camera> camera;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

std::vector<Case> cases() {
    const ProjectiveCameraParams still{.worldToCamera = kPlaced, .fov = 60};
    ProjectiveCameraParams window = still, mirrored = still, moving = still;
    window.hasScreenWindow = true;
    const float screen[] = {-2, 0.5f, -0.3f, 1};
    std::copy_n(screen, 4, window.screenWindow);
    mirrored.worldToCamera = Transform::scale(-2, 2, 2) * kPlaced;
    moving.worldToCamera = AnimatedTransform(kPlaced, Transform::translate(Vec3(0.5f, 0.2f, 1)) * kPlaced);
    std::vector<Case> all;
    for (const auto& [name, params] : {std::pair("", still), std::pair("WithAWindow", window),
                                       std::pair("Mirrored", mirrored), std::pair("Moving", moving)}) {
        static std::vector<std::string> names;
        names.reserve(8);
        all.push_back(
            {names.emplace_back(std::string("Perspective") + name).c_str(), makePerspectiveCamera(params, kFilm)});
        all.push_back(
            {names.emplace_back(std::string("Orthographic") + name).c_str(), makeOrthographicCamera(params, kFilm)});
    }
    return all;
}

class CameraMatrices : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Cameras, CameraMatrices, testing::ValuesIn(cases()),
                         [](const auto& i) { return i.param.name; });

// A point on the ray through a place of the film, when the shutter opens, is projected to that place; in the file's
// world, which here lies elsewhere than the scene's.
TEST_P(CameraMatrices, ProjectToTheFilm) {
    const Camera& camera = *GetParam().camera;
    const Vec3 origin(64, -32, 16);
    const auto toNdc = worldToNdc(camera, kFilm, origin);
    ASSERT_TRUE(toNdc);
    for (const Vec2& film : {Vec2(30, 20), Vec2(3, 7), Vec2(-2, 41), Vec2(59, 30)})
        for (const float distance : {0.7f, 6.f}) {
            const Ray ray = camera.generateRay(film, Vec2(0.5f), 0).ray;
            const Vec3 p = ray.o + ray.d * distance + origin, ndc = toNdc->point(p);
            EXPECT_NEAR(ndc.x * kFilm.width, film.x, 1e-3f);
            EXPECT_NEAR(ndc.y * kFilm.height, film.y, 1e-3f);
            EXPECT_GT(worldToCamera(camera, origin).point(p).z, 0);
        }
}

TEST(CameraMatrices, AreMissingWhereNoMatrixProjects) {
    const auto camera = makeEnvironmentCamera({.worldToCamera = kPlaced}, kFilm);
    EXPECT_FALSE(worldToNdc(*camera, kFilm, Vec3(0.f)));
    EXPECT_NEAR(length(worldToCamera(*camera, Vec3(0.f)).point(Vec3(1, 2, 3))), 0, 1e-5f);
}

}  // namespace
}  // namespace drc
