// Cameras that are given in place of the scene file's.
#include "pbrt/camera_override.h"

#include <gmock/gmock.h>

#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr LookAt kThere{{1, 2, 3}, {4, 0, 9}, {0, 1, 0}};
const std::string kLookAt = "LookAt 1 2 3  4 0 9  0 1 0\n", kElsewhere = "LookAt 5 5 5  0 0 0  1 0 0\n";

std::unique_ptr<Scene> load(const std::string& text, const CameraOverride& camera = {}, const std::string& world = "") {
    LoadOptions options;
    options.camera = camera;
    return loadPbrtString("Film \"image\" \"integer xresolution\" 40 \"integer yresolution\" 20\n" + text +
                              "\nWorldBegin\n" + world + "\nWorldEnd\n",
                          ".", options, "s.pbrt");
}

void expectSameRays(const Scene& a, const Scene& b) {
    for (const Vec2& film : {Vec2(0, 0), Vec2(40, 0), Vec2(13, 17)}) {
        const Ray x = a.sensor.camera->generateRay(film, Vec2(0.5f, 0.5f), 0.25f).ray,
                  y = b.sensor.camera->generateRay(film, Vec2(0.5f, 0.5f), 0.25f).ray;
        EXPECT_LT(length(x.o - y.o), 1e-5f);
        EXPECT_LT(length(x.d - y.d), 1e-5f);
    }
}

TEST(CameraOverride, LooksAsALookAtOfTheFileWould) {
    for (const std::string& camera :
         std::vector<std::string>{"Camera \"perspective\" \"float fov\" 50", "Camera \"orthographic\"", ""})
        expectSameRays(*load(kElsewhere + camera, {.lookAt = kThere}),
                       *load(camera.empty() ? kLookAt + "Camera \"perspective\"" : kLookAt + camera));
}

// Exporters mirror cameras; what is copied from a viewer's LookAt line shows the same picture.
TEST(CameraOverride, KeepsAMirroredCameraMirrored) {
    const std::string camera = "Camera \"perspective\"", mirrored = "Scale -1 1 1\n";
    expectSameRays(*load(mirrored + kElsewhere + camera, {.lookAt = kThere}), *load(mirrored + kLookAt + camera));
}

TEST(CameraOverride, StandsStill) {
    expectSameRays(*load("ActiveTransform EndTime Translate 1 0 0 ActiveTransform All\nCamera \"perspective\"",
                         {.lookAt = kThere}),
                   *load(kLookAt + "Camera \"perspective\""));
}

// A headlight stays at the camera.
TEST(CameraOverride, LightsInTheCamerasSpaceFollow) {
    const std::string world = "CoordSysTransform \"camera\" Translate 0 0 1 Shape \"sphere\" \"float radius\" .1";
    const Bounds here = load(kElsewhere + "Camera \"perspective\"", {.lookAt = kThere}, world)->bounds(),
                 there = load(kLookAt + "Camera \"perspective\"", {}, world)->bounds();
    EXPECT_LT(length(here.min - there.min), 1e-4f);
}

// Far from zero the scene's own origin is another one.
TEST(CameraOverride, IsInTheFilesCoordinates) {
    const std::string world = "Translate 100000 0 0 Shape \"sphere\"";
    const LookAt far{{100000, 0, -5}, {100000, 0, 0}, {0, 1, 0}};
    const auto scene = load("Camera \"perspective\"", {.lookAt = far}, world);
    ASSERT_NE(scene->origin, Vec3(0.f));
    expectSameRays(*scene, *load("LookAt 100000 0 -5  100000 0 0  0 1 0 Camera \"perspective\"", {}, world));
}

TEST(CameraOverride, AFieldOfViewTakesThePlaceOfTheFiles) {
    for (const char* given : {"", "\"float fov\" 20", "\"float halffov\" 10"})
        expectSameRays(*load("Camera \"perspective\" " + std::string(given), {.fov = 70.f}),
                       *load("Camera \"perspective\" \"float fov\" 70"));
    for (const char* camera : {"orthographic", "environment"})
        EXPECT_THAT(errorOf([&] { load("Camera \"" + std::string(camera) + "\"", {.fov = 70.f}); }),
                    AllOf(HasSubstr("s.pbrt:2:8"), HasSubstr("--fov"), HasSubstr(camera), HasSubstr("perspective")));
}

TEST(CameraOverride, SaysWhatIsWrongWithADirection) {
    EXPECT_EQ(kThere.fault(), "");
    EXPECT_THAT((LookAt{{1, 2, 3}, {1, 2, 3}, {0, 1, 0}}.fault()), HasSubstr("same point"));
    EXPECT_THAT((LookAt{{0, 0, 0}, {0, 2, 0}, {0, -1, 0}}.fault()), HasSubstr("along its up vector"));
    EXPECT_THAT((LookAt{{0, 0, 0}, {0, 2, 0}, {0, 0, 0}}.fault()), HasSubstr("zero"));
    EXPECT_THAT((LookAt{{0, 0, 0}, {0, 2e18f, 0}, {0, 0, 1}}.fault()), HasSubstr("1e18"));
}

}  // namespace
}  // namespace drc::pbrt
