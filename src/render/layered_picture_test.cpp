#include "render/layered_picture.h"

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
    Session session(*scene, params, nullptr, nullptr);
    while (session.step()) {
    }
    return session.picture().gBuffer.value();
}

TEST(GBuffer, KnowsHowNoisyItIs) {
    const char *sharp = "", *blurred = "\"float lensradius\" 1.5 \"float focaldistance\" 1.5",
               *moving = "ActiveTransform EndTime Translate 4 0 0 ActiveTransform All";
    EXPECT_LT(gBufferOf(sharp, "", 16).noisyShare, 0.25f);
    EXPECT_GT(gBufferOf(blurred, "", 16).noisyShare, 0.75f);
    EXPECT_GT(gBufferOf(sharp, moving, 16).noisyShare, 0.75f);
    // Noise falls with the number of samples; of a single one nothing is known.
    EXPECT_LT(gBufferOf(blurred, "", 1024).noisyShare, 0.25f);
    EXPECT_EQ(gBufferOf(sharp, "", 1).noisyShare, 1);
}

}  // namespace
}  // namespace drc
