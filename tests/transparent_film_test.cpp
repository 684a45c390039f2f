// A transparent film ("bool transparent"): the camera does not see lights at infinity, and the picture has an alpha.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/folder_testing.h"
#include "image/image_io.h"
#include "pictures.h"

namespace drc {
namespace {

// A ball, half of a mirror, before a sky, and a lamp without a body.
std::string scene(const std::string& film, const std::string& more = "") {
    return "LookAt 0 -4 0  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 50\n"
           "Film \"image\" \"integer xresolution\" 24 \"integer yresolution\" 16 " +
           film +
           "\nWorldBegin\nLightSource \"infinite\" \"rgb L\" [1 2 3]\nMaterial \"matte\"\n"
           "Shape \"sphere\" \"float phimax\" 180\nMaterial \"mirror\"\nRotate 180 0 0 1\n"
           "Shape \"sphere\" \"float phimax\" 180\n" +
           more + "WorldEnd\n";
}
const std::string kTransparent = "\"bool transparent\" \"true\"";

LayeredPicture pictureOf(const std::string& text, const std::string& integrator) {
    const auto scene = pbrt::loadPbrtString(text, ".", {}, "ball.pbrt");
    RenderParams params;
    params.integrator = integrator;
    params.spp = 8;
    params.guide = false;
    Session session(*scene, params);
    while (session.step()) {
    }
    return session.snapshot();
}

class TransparentFilm : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, TransparentFilm, testing::Values("path", "drc", "direct"),
                         [](const auto& i) { return std::string(i.param); });

TEST_P(TransparentFilm, BeforeTheSkyIsTheOpaquePicture) {
    const LayeredPicture opaque = pictureOf(scene(""), GetParam()), clear = pictureOf(scene(kTransparent), GetParam());
    EXPECT_FALSE(opaque.alpha);
    ASSERT_TRUE(clear.alpha);
    const Image& alpha = *clear.alpha;
    int covered = 0, open = 0, edges = 0;
    for (int y = 0; y < alpha.height(); ++y)
        for (int x = 0; x < alpha.width(); ++x) {
            const float a = alpha.at(x, y, 0);
            ++(a == 0 ? open : a == 1 ? covered : edges);
            const Rgb over = clear.beauty.rgb(x, y) + Rgb(1, 2, 3) * (1 - a), seen = opaque.beauty.rgb(x, y);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(over[c], seen[c], 1e-4f) << x << " " << y;
        }
    EXPECT_GT(covered, 50);
    EXPECT_GT(open, 150);
    EXPECT_GT(edges, 15);
}

// Its random numbers depend on what is seen, so the pictures are not the same sample by sample.
TEST(TransparentFilmOfBdpt, HasTheAlphaOfPaths) {
    const LayeredPicture paths = pictureOf(scene(kTransparent), "path"), both = pictureOf(scene(kTransparent), "bdpt");
    EXPECT_EQ(paths.alpha->data(), both.alpha->data());
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 24; ++x)
            if (paths.alpha->at(x, y, 0) == 0) {
                EXPECT_TRUE(isBlack(both.beauty.rgb(x, y)));
            }
}

TEST(TransparentFilmOf, ALampWithoutABodyIsAGlowBeforeNothing) {
    const std::string lamp =
        "Rotate 180 0 0 1\nTranslate 0 1.5 0\nMaterial \"\"\nAreaLightSource \"diffuse\" \"rgb L\" [7 7 7]\n"
        "Shape \"sphere\" \"float radius\" 5\n";
    const LayeredPicture picture = pictureOf(scene(kTransparent, lamp), "path");
    EXPECT_EQ(picture.alpha->at(0, 0, 0), 0);
    EXPECT_NEAR(picture.beauty.rgb(0, 0).x, 7, 1e-3);
}

TEST(TransparentFilmOf, IntegratorsWithoutItSaySo) {
    EXPECT_THAT(errorOf([] { pictureOf(scene(kTransparent), "drc-maps"); }), testing::HasSubstr("have no alpha"));
}

}  // namespace
}  // namespace drc
