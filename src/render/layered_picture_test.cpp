#include "film/layered_picture.h"

#include <gtest/gtest.h>

#include "pbrt/scene_file.h"
#include "render/session.h"

namespace drc {
namespace {

// Tiles of two colours on a wall, seen sharply, out of focus, or while they move.
GBuffer gBufferOf(const std::string& camera, const std::string& motion, int spp) {
    const auto scene = pbrt::loadPbrtString(
        "Film \"image\" \"integer xresolution\" 24 \"integer yresolution\" 16\n"
        "LookAt 0 0 -3  0 0 0  0 1 0\n"
        "Camera \"perspective\" \"float fov\" 70 " +
            camera + R"(
        WorldBegin
        LightSource "point" "point from" [0 0 -2]
        Texture "tiles" "spectrum" "checkerboard" "float uscale" 2 "float vscale" 2
            "rgb tex1" [.1 .1 .1] "rgb tex2" [.9 .6 .3]
        Material "matte" "texture Kd" "tiles"
        AttributeBegin
        )" + motion +
            R"(
        Shape "trianglemesh" "integer indices" [0 1 2 0 2 3]
            "point P" [-4 -4 1  4 -4 1  4 4 1  -4 4 1] "float uv" [0 0 1 0 1 1 0 1]
        AttributeEnd
        WorldEnd)",
        ".", {}, "s.pbrt");
    RenderParams params;
    params.integrator = "path";
    params.spp = spp;
    params.gBuffer = true;
    Session session(*scene, params);
    while (session.step()) {
    }
    return session.picture().gBuffer.value();
}

TEST(GBuffer, KnowsHowNoisyItIs) {
    const char *sharp = "", *blurred = "\"float lensradius\" 1.5 \"float focaldistance\" 1.5",
               *moving = "ActiveTransform EndTime Translate 4 0 0 ActiveTransform All";
    const float still = gBufferOf(sharp, "", 16).noise, lens = gBufferOf(blurred, "", 16).noise;
    EXPECT_GT(lens, 2 * still);
    EXPECT_GT(gBufferOf(sharp, moving, 16).noise, 1.5f * still);
    // The colours of the tiles, as vectors, are 0.97 apart; where they mix evenly the samples deviate by half of that.
    EXPECT_NEAR(lens, 0.97f / 2 / std::sqrt(15.f), 0.04f);
    EXPECT_NEAR(gBufferOf(blurred, "", 64).noise, lens / 2, 0.1f * lens);
    EXPECT_EQ(gBufferOf(sharp, "", 1).noise, 1);  // nothing is known
}

TEST(GBuffer, KeepsItsOtherSamplesBesideABrokenOne) {
    std::vector<FilmLayerSpec> specs;
    addGBufferSpec(specs, 1);
    FilmLayer layer({0, 0, 1, 1}, specs[0]);
    GBufferSample good{.albedo = Rgb(0.5f), .normal = Vec3(0, 0, 1), .depth = 2}, broken = good;
    broken.albedo.y = std::numeric_limits<float>::quiet_NaN();
    broken.depth = kInfinity;
    addGBufferSample(layer, 0, 0, good, 1, 0);
    addGBufferSample(layer, 0, 0, broken, 1, 0);
    EXPECT_NEAR(layer.sum(0, 0, 0), 1, 1e-6);
    EXPECT_NEAR(layer.sum(0, 0, 1), 0.5, 1e-6);
    EXPECT_NEAR(layer.sum(0, 0, 5), 2, 1e-6);
    EXPECT_NEAR(layer.sum(0, 0, 6), 2, 1e-6);
}

TEST(LayeredPicture, ColoursOfAllLayersAreBalanced) {
    LayeredPicture picture;
    picture.layers.push_back({"a", "direct", Image(1, 1), Image(1, 1)});
    picture.layers[0].mean.setRgb(0, 0, Rgb(1, 2, -1));
    picture.layers[0].variance->setRgb(0, 0, Rgb(1, 4, 0));
    picture.layers.push_back({"b", "indirect", Image(1, 1), std::nullopt});
    picture.beauty = Image(1, 1);
    picture.beauty.setRgb(0, 0, Rgb(1, 3, 2));
    picture.balance({{Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, -1, 1)}});
    EXPECT_EQ(picture.layers[0].mean.rgb(0, 0), Rgb(2, 1, -3));
    EXPECT_EQ(picture.layers[0].variance->rgb(0, 0), Rgb(4, 1, 4));
    EXPECT_EQ(picture.beauty.rgb(0, 0), Rgb(3, 1, 0));
}

}  // namespace
}  // namespace drc
