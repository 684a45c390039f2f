// Motion in scene files.
#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kEnd = "ActiveTransform EndTime Translate 4 0 0 ActiveTransform All\n";

std::unique_ptr<Scene> withOptions(const std::string& options, const std::string& world = "") {
    return loadPbrtString(options + "\nWorldBegin\n" + world + "\nWorldEnd\n", ".", {}, "moving.pbrt");
}
Ray rayAt(const Scene& scene, float u) {
    return scene.sensor.camera->generateRay(Vec2(640, 360), Vec2(0.5f, 0.5f), u).ray;
}
// Number of warnings that loading gives.
template <typename F>
std::string warningsOf(const F& f) {
    forgetWarnings();  // identical warnings are printed once, so earlier ones must be forgotten
    testing::internal::CaptureStderr();
    f();
    return testing::internal::GetCapturedStderr();
}

TEST(MovingScene, ActiveTransformMovesShapesAndInstances) {
    const auto scene = loadWorld(kEnd + "Shape \"sphere\"\nObjectBegin \"o\"\nObjectEnd\nObjectInstance \"o\"\n");
    EXPECT_TRUE(scene->primitives.empty());
    ASSERT_EQ(scene->instances.size(), 1u) << "an object without shapes needs no instance";
    const AnimatedTransform& t = scene->instances[0].objectToWorld;
    EXPECT_EQ(t.start().point(Vec3(0, 0, 0)), Vec3(0, 0, 0));
    EXPECT_EQ(t.at(0.25f).point(Vec3(0, 0, 0)), Vec3(1, 0, 0));
    EXPECT_EQ(t.end().point(Vec3(0, 0, 0)), Vec3(4, 0, 0));

    const auto object = loadWorld("ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\n" + kEnd + "ObjectInstance \"o\"\n");
    ASSERT_EQ(object->instances.size(), 1u);
    EXPECT_EQ(object->instances[0].objectToWorld.at(0.5f).point(Vec3(0, 0, 1)), Vec3(2, 0, 1));
}

TEST(MovingScene, WithoutDifferenceNothingMoves) {
    const auto scene = loadWorld(
        "ActiveTransform StartTime Translate 1 0 0 ActiveTransform EndTime Translate 1 0 0 ActiveTransform All\n"
        "Shape \"sphere\"\n");
    EXPECT_EQ(scene->primitives.size(), 1u);
    EXPECT_TRUE(scene->instances.empty());
}

TEST(MovingScene, BlocksAndWorldBeginRestoreTheActiveTransforms) {
    const auto scene =
        loadWorld("TransformBegin ActiveTransform EndTime TransformEnd Translate 1 0 0\nShape \"sphere\"\n");
    EXPECT_EQ(scene->primitives.size(), 1u);
    const auto options = withOptions("ActiveTransform EndTime", "Translate 1 0 0\nShape \"sphere\"");
    EXPECT_EQ(options->primitives.size(), 1u);
}

TEST(MovingScene, CamerasMove) {
    // The world moves by +4 along x in camera space, so the camera moves by -4.
    const auto scene = withOptions(kEnd + "Camera \"perspective\"");
    EXPECT_LT(length(rayAt(*scene, 0).o), 1e-6f);
    EXPECT_LT(length(rayAt(*scene, 0.25f).o - Vec3(-1, 0, 0)), 1e-5f);
    EXPECT_LT(length(rayAt(*scene, 1).o - Vec3(-4, 0, 0)), 1e-5f);
    EXPECT_LT(length(scene->sensor.camera->position() - Vec3(-2, 0, 0)), 1e-5f);
    // A camera that rotates about its own position stays there, and halfway it has rotated by half the angle.
    for (const char* type : {"perspective", "orthographic", "environment"}) {
        const auto turning = withOptions(
            "ActiveTransform EndTime Rotate 90 0 1 0 ActiveTransform All Translate 1 2 3\n"
            "Camera \"" +
            std::string(type) + "\"");
        const Ray start = rayAt(*turning, 0), middle = rayAt(*turning, 0.5f), end = rayAt(*turning, 1);
        EXPECT_NEAR(dot(start.d, end.d), 0, 1e-4) << type;
        EXPECT_NEAR(dot(start.d, middle.d), std::sqrt(0.5f), 1e-4) << type;
        EXPECT_LT(length(middle.o - Vec3(-1, -2, -3)), std::string(type) == "orthographic" ? 0.01f : 1e-4f) << type;
        EXPECT_EQ(middle.time, 0.5f);
    }
}

TEST(MovingScene, TransformTimesAndShutter) {
    const auto timeAt = [](const std::string& options, const std::string& shutter, float u) {
        return rayAt(*withOptions(options + "\nCamera \"perspective\" " + shutter), u).time;
    };
    EXPECT_EQ(timeAt("", "", 0.25f), 0.25f);
    EXPECT_EQ(timeAt("TransformTimes 0 2", "", 0.5f), 0.25f);
    EXPECT_EQ(timeAt("TransformTimes 1 3", "\"float shutteropen\" 2 \"float shutterclose\" 4", 0), 0.5f);
    // Before and after the motion, the ends hold.
    EXPECT_EQ(timeAt("TransformTimes 1 3", "\"float shutteropen\" 2 \"float shutterclose\" 4", 0.9f), 1);
    EXPECT_EQ(timeAt("TransformTimes 0.5 1", "", 0.25f), 0);
    // If both times are equal, everything jumps from the start to the end at that time.
    EXPECT_EQ(timeAt("TransformTimes 0.5 0.5", "", 0.25f), 0);
    EXPECT_EQ(timeAt("TransformTimes 0.5 0.5", "", 0.75f), 1);
    EXPECT_THAT(warningsOf([&] { EXPECT_EQ(timeAt("TransformTimes 0.5 0", "", 0.75f), 1); }),
                HasSubstr("moving.pbrt:1:1: warning: the second of the TransformTimes"));
    // TransformTimes may also follow the camera, as long as it is before WorldBegin.
    EXPECT_EQ(rayAt(*withOptions("Camera \"perspective\"\nTransformTimes 0 4"), 0.5f).time, 0.125f);
    EXPECT_THAT(errorOfWorld("TransformTimes 0 1"), HasSubstr("s.pbrt:2:1"));
}

TEST(MovingScene, WhatCannotMoveSaysSo) {
    std::unique_ptr<Scene> scene;
    EXPECT_THAT(warningsOf([&] {
                    scene = withOptions("", kEnd + "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\nShape \"sphere\"");
                }),
                HasSubstr("moving.pbrt:5:7: warning: shapes that move cannot be area lights; it does not emit"));
    EXPECT_TRUE(scene->lights.empty());
    EXPECT_EQ(scene->objects.at(0).primitives.at(0).areaLight, nullptr);
    EXPECT_THAT(
        warningsOf([&] { scene = withOptions("", "\n" + kEnd + "LightSource \"point\""); }),
        HasSubstr("moving.pbrt:5:13: warning: lights cannot move; the transformation of the start time is used"));
    EXPECT_EQ(scene->lights.size(), 1u);
    EXPECT_THAT(
        warningsOf([&] { withOptions("", "\n\n" + kEnd + "Texture \"t\" \"float\" \"fbm\""); }),
        HasSubstr("moving.pbrt:6:21: warning: textures cannot move; the transformation of the start time is used"));
}

// The object would be flat on the way, and rays cannot be transformed to a flat space.
TEST(MovingScene, NothingMovesToItsMirrorImage) {
    const std::string mirror = "ActiveTransform EndTime Scale 1 -1 1 ActiveTransform All\n";
    const std::string why = " cannot move from a place to one where it is mirrored";
    const std::string object = "ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\n";
    EXPECT_THAT(errorOfWorld(mirror + "Shape \"disk\""), StartsWith("s.pbrt:3:7: the shape 'disk'" + why));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"o\"\n" + mirror + "Shape \"disk\"\nObjectEnd"),
                StartsWith("s.pbrt:4:7: the shape 'disk'" + why));
    EXPECT_THAT(errorOfWorld(object + mirror + "ObjectInstance \"o\""),
                StartsWith("s.pbrt:6:16: the object 'o'" + why));
    EXPECT_THAT(errorOfScene(mirror + "Camera \"perspective\"\nWorldBegin\nWorldEnd"),
                StartsWith("s.pbrt:2:8: the camera" + why));
    // Motions that mirror at both times, about any axis, or that carry a mirrored object along, must work.
    const std::string both = "ActiveTransform StartTime Scale -1 1 1 " + mirror;
    EXPECT_EQ(errorOfWorld(both + "Shape \"disk\"\n" + mirror + mirror + "Shape \"disk\""), "");
    EXPECT_EQ(
        errorOfScene(both + "Camera \"perspective\"\nWorldBegin\n" + object + both + "ObjectInstance \"o\"\nWorldEnd"),
        "");
}

TEST(MovingScene, ShapesOfObjectsAreNoLightsAndObjectsDoNotNest) {
    std::unique_ptr<Scene> scene;
    EXPECT_THAT(warningsOf([&] {
                    scene = withOptions("",
                                        "\n\n\nObjectBegin \"o\"\nAreaLightSource \"diffuse\"\nShape \"disk\"\n"
                                        "ObjectEnd\nObjectInstance \"o\"");
                }),
                HasSubstr("moving.pbrt:8:7: warning: shapes of an instanced object cannot be area lights"));
    EXPECT_TRUE(scene->lights.empty());
    EXPECT_EQ(scene->objects.at(0).primitives.at(0).areaLight, nullptr);
    const std::string nested = "ObjectBegin \"a\"\nObjectEnd\nObjectBegin \"b\"\nObjectInstance \"a\"\nObjectEnd";
    EXPECT_THAT(errorOfWorldV4(nested), HasSubstr("s.pbrt:5:16: ObjectInstance inside of an object"));
    EXPECT_THAT(warningsOfWorld(nested), HasSubstr("s.pbrt:5:16: warning: ObjectInstance inside of an object: objects "
                                                   "cannot be nested; the instance is left out"));
    EXPECT_THAT(errorOfWorldV4("ObjectEnd"), HasSubstr("ObjectEnd without ObjectBegin"));
}

}  // namespace
}  // namespace drc::pbrt
