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
            const ViewCamera view = ViewCamera::of(*scene->sensor.camera, 2);
            EXPECT_TRUE(view.isUsable());
            EXPECT_NEAR(length(view.look - view.eye), 2, 1e-4f);
            expectSameRays(*scene->sensor.camera, *view.place(*scene->sensor.camera, scene->sensor.settings.film),
                           1e-4f);
        }
    }
}

// The lines for a scene file give the same rays.
TEST(ViewCamera, IsWrittenAsPbrt) {
    for (const char* placement : {"LookAt 1 2 3  0 0.5 0  0 1 0", "Scale -1 1 1 LookAt 1 2 3  0 0.5 0  0 1 0"}) {
        const auto scene = sceneWith(placement);
        ViewCamera view = ViewCamera::of(*scene->sensor.camera, 2);
        view.eye += Vec3(0.5f, 0.25f, -1);
        const auto moved = view.place(*scene->sensor.camera, scene->sensor.settings.film);
        expectSameRays(*moved, *sceneWith(view.asPbrt(scene->origin))->sensor.camera, 1e-4f);
    }
}

// A lens in place of that of the scene, whichever kind of camera it has; also as pbrt.
TEST(ViewCamera, MayHaveALensOfItsOwn) {
    const std::string place = "LookAt 1 2 3  0 0.5 0  0 1 0\n", mirrored = "Scale -1 1 1 " + place;
    const std::string cameras[] = {
        "\"perspective\" \"float screenwindow\" [-0.5 1 -0.25 0.75] \"float fov\" 90 \"float shutteropen\" 0.25",
        "\"perspective\" \"float screenwindow\" [-0.5 1 -0.25 0.75] \"float fov\" 90 \"float lensradius\" 0.1 "
        "\"float focaldistance\" 3 \"float shutteropen\" 0.25",
        "\"orthographic\" \"float screenwindow\" [-0.5 1 -0.25 0.75] \"float lensradius\" 0.1 "
        "\"float focaldistance\" 3 \"float shutteropen\" 0.25"};
    const ViewLens lenses[] = {{false, {-0.5f, 1, -0.25f, 0.75f}},
                               {false, {-0.5f, 1, -0.25f, 0.75f}, 0.1f, 3},
                               {true, {-0.5f, 1, -0.25f, 0.75f}, 0.1f, 3}};
    for (const std::string& at : {place, mirrored})
        for (const char* own :
             {"\"perspective\" \"float shutteropen\" 0.25", "\"orthographic\" \"float shutteropen\" 0.25",
              "\"environment\" \"float shutteropen\" 0.25"})
            for (int i = 0; i < 3; ++i) {
                const auto scene = sceneWith(at, own), expected = sceneWith(at, cameras[i]);
                ViewCamera view = ViewCamera::of(*scene->sensor.camera, 2);
                view.lens = lenses[i];
                EXPECT_TRUE(view.isUsable());
                const auto camera = view.place(*scene->sensor.camera, scene->sensor.settings.film);
                expectSameRays(*camera, *expected->sensor.camera, 1e-4f);
                const Vec2 film(10, 20), lens(0.3f, 0.4f);
                EXPECT_EQ(camera->generateRay(film, lens, 0.5f).ray.time,
                          expected->sensor.camera->generateRay(film, lens, 0.5f).ray.time);
                expectSameRays(
                    *camera,
                    *pbrt::loadPbrtString(view.asPbrt(scene->origin) + "Film \"image\" \"integer xresolution\" 40 "
                                                                       "\"integer yresolution\" 30\nWorldBegin\n"
                                                                       "Shape \"sphere\"\nWorldEnd\n")
                         ->sensor.camera,
                    1e-4f);
            }
}

TEST(ViewCamera, KnowsLensesThatShowNothing) {
    ViewCamera view{.eye = {1, 2, 3}, .look = {0, 0, 0}, .up = {0, 1, 0}};
    const ViewLens good{false, {-1, 1, -1, 1}, 0.1f, 2};
    const auto isUsable = [&](auto change) {
        ViewLens lens = good;
        change(lens);
        view.lens = lens;
        return view.isUsable();
    };
    EXPECT_TRUE(isUsable([](ViewLens&) {}));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.window[0] = 1; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.window[2] = 2; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.window[1] = kInfinity; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.window[3] = NAN; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.radius = -1; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.radius = kInfinity; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.focalDistance = 0; }));
    EXPECT_FALSE(isUsable([](ViewLens& l) { l.focalDistance = NAN; }));
}

// A scene far from zero is moved there, where floats are fine; only what is written is in the file's space.
TEST(ViewCamera, IsExactFarFromZero) {
    const auto scene = pbrt::loadPbrtString(
        "LookAt 100001 2 3  100000 2 0  0 1 0\nCamera \"perspective\"\nWorldBegin\nTranslate 100000 2 0\n"
        "Shape \"sphere\"\nWorldEnd\n");
    ASSERT_NE(scene->origin, Vec3(0.f));
    const ViewCamera view = ViewCamera::of(*scene->sensor.camera, 1);
    EXPECT_THAT(view.asPbrt(scene->origin), testing::StartsWith("LookAt 100001 2 3  100000."));
    expectSameRays(*scene->sensor.camera, *view.place(*scene->sensor.camera, scene->sensor.settings.film), 1e-4f);
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
