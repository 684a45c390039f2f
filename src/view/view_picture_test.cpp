#include "view/view_picture.h"

#include <gtest/gtest.h>

#include "pbrt/scene_file.h"

namespace drc {
namespace {

const PixelRegion kWhole{0, 0, 40, 20};

ViewPicture pictureOf(const std::string& placement, const std::string& camera, const PixelRegion& region = kWhole) {
    const auto scene =
        pbrt::loadPbrtString(placement + "\nCamera " + camera +
                             "\nFilm \"image\" \"integer xresolution\" 40 \"integer yresolution\" 20\nWorldBegin\n"
                             "Shape \"sphere\"\nWorldEnd\n");
    return ViewPicture::of(*scene->sensor.camera, ViewCamera::of(*scene->sensor.camera, 1), region);
}

void expectNear(const Vec3& a, const Vec3& b) { EXPECT_LT(length(a - b), 1e-4f) << a << " is not " << b; }

constexpr const char* kPlace = "LookAt 1 2 3  0 0.5 0  0 1 0";
constexpr const char* kMirrored = "Scale -1 1 1 LookAt 1 2 3  0 0.5 0  0 0 1";

TEST(ViewPicture, OfAPerspectiveHasTheWidthAtDistanceOne) {
    const ViewPicture picture = pictureOf(kPlace, "\"perspective\" \"float fov\" 90");
    EXPECT_EQ(picture.kind, ViewPicture::Kind::Perspective);
    EXPECT_NEAR(picture.width, 4, 1e-3f);
    expectNear(picture.ahead, {0, 0, 1});
    expectNear(picture.right, {1, 0, 0});
    expectNear(picture.top, {0, 1, 0});
    // Of a part, and of one beside the axis.
    EXPECT_NEAR(pictureOf(kPlace, "\"perspective\" \"float fov\" 90", {30, 0, 40, 20}).width, 1, 1e-3f);
    EXPECT_NEAR(pictureOf(kPlace, "\"perspective\" \"float fov\" 90 \"float screenwindow\" [1 3 0 1]").width, 2, 1e-3f);
}

// The right of the picture is where it is seen: on the other side of a mirrored camera.
TEST(ViewPicture, KnowsMirroredCameras) {
    for (const char* camera : {"\"perspective\" \"float fov\" 50 \"float lensradius\" 0.1", "\"orthographic\""}) {
        const ViewPicture picture = pictureOf(kMirrored, camera);
        expectNear(picture.right, {-1, 0, 0});
        expectNear(picture.top, {0, 1, 0});
        expectNear(picture.ahead, {0, 0, 1});
    }
}

TEST(ViewPicture, OfParallelRaysHasAWindow) {
    const ViewPicture picture = pictureOf(kMirrored, "\"orthographic\" \"float screenwindow\" [-0.5 1 -0.25 0.75]");
    EXPECT_EQ(picture.kind, ViewPicture::Kind::Parallel);
    EXPECT_NEAR(picture.width, 1.5f, 1e-4f);
    const float expected[] = {-0.5f, 1, -0.25f, 0.75f};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(picture.window[size_t(i)], expected[i], 1e-4f) << i;
}

// pbrt's environment camera shows in its middle what is on its left, and its right edge is behind that: as in a mirror.
TEST(ViewPicture, OfAPanoramaGoesAround) {
    const ViewPicture picture = pictureOf(kPlace, "\"environment\"");
    EXPECT_EQ(picture.kind, ViewPicture::Kind::Panorama);
    EXPECT_NEAR(picture.width, 2 * kPi, 1e-3f);
    expectNear(picture.ahead, {-1, 0, 0});
    expectNear(picture.right, {0, 0, -1});
    expectNear(picture.top, {0, 1, 0});
}

}  // namespace
}  // namespace drc
