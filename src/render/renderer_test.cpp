#include "render/renderer.h"

#include <gtest/gtest.h>

#include "pbrt/scene_file.h"

namespace drc {
namespace {

// A bright strip across a dim sky, through a filter that undershoots beside it.
TEST(Renderer, PicturesHaveNoLightBelowZero) {
    const auto scene = pbrt::loadPbrtString(R"(
        Film "image" "integer xresolution" 24 "integer yresolution" 24
        PixelFilter "sinc"
        Camera "perspective" "float fov" 90
        WorldBegin
        LightSource "infinite" "rgb L" [.01 .01 .01]
        AreaLightSource "diffuse" "rgb L" [50 50 50] "bool twosided" "true"
        Translate 0 0 1
        Shape "trianglemesh" "point P" [-2 -.2 0 2 -.2 0 2 .2 0 -2 .2 0] "integer indices" [0 1 2 0 2 3]
        WorldEnd)",
                                            ".", {}, "s.pbrt");
    RenderParams params;
    params.integrator = Integrator::Path;
    params.spp = 16;
    Renderer renderer(*scene, params, nullptr, nullptr);
    while (renderer.step()) {
    }
    const Image picture = renderer.image().beauty;
    int black = 0, dim = 0, bright = 0;
    for (const float v : picture.data()) {
        EXPECT_GE(v, 0);
        black += v == 0;
        dim += v > 0.009f && v < 0.011f;
        bright += v > 40;
    }
    EXPECT_GT(black, 50);  // where the sky alone would be grey
    EXPECT_GT(dim, 50);
    EXPECT_GT(bright, 50);
}

}  // namespace
}  // namespace drc
