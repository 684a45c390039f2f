#include "view/view_camera.h"

#include <gtest/gtest.h>

#include "pbrt/scene_file.h"

namespace drc {
namespace {

std::unique_ptr<Scene> sceneWith(const std::string& placement,
                                 const std::string& camera = "\"perspective\" \"float fov\" 50") {
    return pbrt::loadPbrtString(placement + "\nCamera " + camera +
                                "\nFilm \"image\" \"integer xresolution\" 40 \"integer yresolution\" 30\nWorldBegin\n"
                                "Shape \"sphere\"\nWorldEnd\n");
}

void expectSameRays(const Camera& a, const Camera& b, float tolerance) {
    for (const Vec2& film : {Vec2(0, 0), Vec2(40, 0), Vec2(13, 22), Vec2(20, 15)}) {
        const Ray one = a.generateRay(film, Vec2(0.3f, 0.4f), 0.5f).ray,
                  two = b.generateRay(film, Vec2(0.3f, 0.4f), 0.5f).ray;
        EXPECT_LT(length(one.o - two.o), tolerance);
        EXPECT_LT(length(one.d - two.d), 1e-5f);
    }
}

// The scene's camera, put into these terms and back, is where it was: also where left and right are swapped.
TEST(ViewCamera, IsTheScenesOwnAtFirst) {
    for (const char* placement :
         {"LookAt 1 2 3  0 0.5 0  0 1 0", "LookAt 1 2 3  0 0.5 0  0 0 1", "Scale -1 1 1 LookAt 1 2 3  0 0.5 0  0 1 0",
          "Rotate 20 0 0 1 Translate 1 2 3", "Transform [1 0 0 0  0 0 1 0  0 1 0 0  3 4 5 1]"}) {
        for (const char* camera :
             {"\"perspective\" \"float fov\" 50 \"float lensradius\" 0.1 \"float focaldistance\" 3", "\"orthographic\"",
              "\"environment\""}) {
            const auto scene = sceneWith(placement, camera);
            const ViewCamera view = ViewCamera::of(*scene, 2);
            EXPECT_TRUE(view.isUsable());
            EXPECT_NEAR(length(view.look - view.eye), 2, 1e-4f);
            expectSameRays(*scene->camera, *view.place(*scene, scene->settings.film), 1e-4f);
        }
    }
}

// The lines for a scene file give the same rays.
TEST(ViewCamera, IsWrittenAsPbrt) {
    for (const char* placement : {"LookAt 1 2 3  0 0.5 0  0 1 0", "Scale -1 1 1 LookAt 1 2 3  0 0.5 0  0 1 0"}) {
        const auto scene = sceneWith(placement);
        ViewCamera view = ViewCamera::of(*scene, 2);
        view.eye += Vec3(0.5f, 0.25f, -1);
        const auto moved = view.place(*scene, scene->settings.film);
        expectSameRays(*moved, *sceneWith(view.asPbrt(scene->origin))->camera, 1e-4f);
    }
}

// A scene far from zero is moved there, where floats are fine; only what is written is in the file's space.
TEST(ViewCamera, IsExactFarFromZero) {
    const auto scene = pbrt::loadPbrtString(
        "LookAt 100001 2 3  100000 2 0  0 1 0\nCamera \"perspective\"\nWorldBegin\nTranslate 100000 2 0\n"
        "Shape \"sphere\"\nWorldEnd\n");
    ASSERT_NE(scene->origin, Vec3(0.f));
    const ViewCamera view = ViewCamera::of(*scene, 1);
    EXPECT_THAT(view.asPbrt(scene->origin), testing::StartsWith("LookAt 100001 2 3  100000."));
    expectSameRays(*scene->camera, *view.place(*scene, scene->settings.film), 1e-4f);
}

TEST(ViewCamera, KnowsWhenItLooksNowhere) {
    ViewCamera view{.eye = {1, 2, 3}, .look = {0, 0, 0}, .up = {0, 1, 0}};
    EXPECT_TRUE(view.isUsable());
    view.up = {1, 2, 3};
    EXPECT_FALSE(view.isUsable());
    view.up = {0, 0, 0};
    EXPECT_FALSE(view.isUsable());
    view.up = {0, 1, 0};
    view.look = view.eye;
    EXPECT_FALSE(view.isUsable());
    view.look = {kInfinity, 0, 0};
    EXPECT_FALSE(view.isUsable());
}

}  // namespace
}  // namespace drc
