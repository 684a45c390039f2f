// Cameras in scene files.
#include <gmock/gmock.h>

#include "base/log.h"
#include "pbrt/test_scenes.h"

namespace drc::pbrt {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::unique_ptr<Scene> withCamera(const std::string& camera, const std::string& directory = ".") {
    return loadPbrtString("Film \"image\" \"integer xresolution\" 100 \"integer yresolution\" 100\nCamera " + camera +
                              "\nWorldBegin\nWorldEnd\n",
                          directory, {}, "s.pbrt");
}
Ray rayOf(const std::string& camera, const Vec2& film, const Vec2& uLens = Vec2(0.5f, 0.5f)) {
    return withCamera(camera)->sensor.camera->generateRay(film, uLens, 0.5f).ray;
}
std::string errorOfCamera(const std::string& camera, const std::string& directory = ".") {
    return errorOf([&] { withCamera(camera, directory); });
}

TEST(CameraFactory, Perspective) {
    EXPECT_LT(length(rayOf("\"perspective\"", Vec2(0, 50)).d - normalize(Vec3(-1, 0, 1))), 1e-5f);
    EXPECT_LT(length(rayOf("\"perspective\" \"float halffov\" 45", Vec2(0, 50)).d - normalize(Vec3(-1, 0, 1))), 1e-5f);
    const Ray r = rayOf(
        "\"perspective\" \"float screenwindow\" [0 2 0 1] \"float lensradius\" 1 \"float focaldistance\" 2 "
        "\"float shutteropen\" .5 \"float shutterclose\" 1",
        Vec2(100, 0), Vec2(1, 0.5f));
    EXPECT_EQ(r.time, 0.75f);
    EXPECT_LT(length(r.o - Vec3(1, 0, 0)), 1e-5f);
    EXPECT_LT(length(r.o + r.d * (2 / r.d.z) - Vec3(4, 2, 2)), 1e-4f);
    EXPECT_THAT(errorOfCamera("\"perspective\" \"float fov\" 180"), HasSubstr("between 0 and 180"));
}

TEST(CameraFactory, OrthographicAndEnvironment) {
    const Ray r = rayOf("\"orthographic\" \"float screenwindow\" [0 4 0 8]", Vec2(25, 25));
    EXPECT_LT(length(r.o - Vec3(1, 6, 0)), 1e-5f);
    EXPECT_LT(length(rayOf("\"environment\" \"float lensradius\" 1", Vec2(50, 50)).d - Vec3(-1, 0, 0)), 1e-5f);
    EXPECT_LT(length(rayOf("\"orthographic\" \"float frameaspectratio\" 3", Vec2(0, 0)).o - Vec3(-3, 1, 0)), 1e-5f);
}

const std::string kLens =
    "# a biconvex lens\n"
    "50 6 1.5 30  # front\n"
    "-50\t3 1 30\n"
    "0 45 0 20\n";

TEST(CameraFactory, RealisticReadsItsLens) {
    const TemporaryFolder folder;
    folder.write("lens.dat", kLens);
    const std::string camera = "\"realistic\" \"string lensfile\" \"lens.dat\" ";
    forgetWarnings();
    const auto scene = withCamera(camera + "\"float aperturediameter\" 8 \"float focusdistance\" 3", folder.path());
    EXPECT_EQ(warningCount(), 0);
    // About 50 mm in front of a film with a diagonal of 35 mm: the corner is at 18.7 degrees from the axis.
    const CameraRay corner = scene->sensor.camera->generateRay(Vec2(0, 0), Vec2(0.5f, 0.5f), 0);
    ASSERT_GT(corner.weight, 0);
    EXPECT_NEAR(std::acos(corner.ray.d.z) * 180 / kPi, 18.7, 1.5);
    EXPECT_LT(corner.ray.d.x, 0);
    EXPECT_GT(corner.ray.d.y, 0);
    withCamera(camera + "\"float aperturediameter\" 21", folder.path());
    EXPECT_EQ(warningCount(), 1) << "the stop opens to 20 mm";
    EXPECT_THAT(errorOfCamera(camera + "\"float focusdistance\" .1", folder.path()),
                AllOf(HasSubstr("s.pbrt:2:8"), HasSubstr("cannot be focused as near as 0.1")));
    EXPECT_THAT(errorOfCamera("\"realistic\""), HasSubstr("needs the parameter \"string lensfile\""));
    EXPECT_THAT(errorOfCamera("\"realistic\" \"string lensfile\" \"no.dat\""), HasSubstr("no.dat"));
}

// Focusing replaces the last distance, which is 0 in pbrt's own lens files.
TEST(CameraFactory, RealisticDoesNotCareForTheLastDistance) {
    const TemporaryFolder folder;
    const auto raysWith = [&](const std::string& last) {
        folder.write("lens.dat", "40 4 1.5 16\n0 3 0 10\n-40 " + last + " 1 16\n");
        const auto scene = withCamera(
            "\"realistic\" \"string lensfile\" \"lens.dat\" \"float aperturediameter\" 8 "
            "\"float focusdistance\" 3",
            folder.path());
        std::vector<CameraRay> rays;
        for (int i = 0; i < 64; ++i)
            rays.push_back(scene->sensor.camera->generateRay(Vec2(float(i) * 1.3f, 40), Vec2(0.3f, float(i) / 64), 0));
        return rays;
    };
    const auto expected = raysWith("30");
    for (const char* last : {"0", "5", "0.001", "1000"}) {
        const auto rays = raysWith(last);
        for (size_t i = 0; i < rays.size(); ++i) {
            EXPECT_EQ(rays[i].weight, expected[i].weight);
            EXPECT_EQ(rays[i].ray.o, expected[i].ray.o);
            EXPECT_EQ(rays[i].ray.d, expected[i].ray.d);
        }
    }
}

TEST(CameraFactory, LensFilesThatAreNone) {
    const TemporaryFolder folder;
    const auto errorOfLens = [&](const std::string& text) {
        folder.write("bad.dat", text);
        return errorOfCamera("\"realistic\" \"string lensfile\" \"bad.dat\"", folder.path());
    };
    EXPECT_THAT(errorOfLens("50 6 1.5 30\n-50 3 x 30\n"),
                AllOf(HasSubstr("bad.dat:2:7"), HasSubstr("'x' is no number")));
    EXPECT_THAT(errorOfLens("50 6 1.5 30\n-50 3 1\n"), AllOf(HasSubstr("bad.dat:2:7"), HasSubstr("four numbers")));
    EXPECT_THAT(errorOfLens("# nothing\n"), HasSubstr("this one has 0 in all"));
    EXPECT_THAT(errorOfLens("50 6 .5 30\n"), AllOf(HasSubstr("bad.dat:1:6"), HasSubstr("index of refraction")));
    EXPECT_THAT(errorOfLens("50 6 1.5 0\n"), AllOf(HasSubstr("bad.dat:1:10"), HasSubstr("diameter")));
    EXPECT_THAT(errorOfLens("50 -6 1.5 30\n-50 0 1 30"),
                AllOf(HasSubstr("bad.dat:1:4"), HasSubstr("must not be negative")));
}

}  // namespace
}  // namespace drc::pbrt
