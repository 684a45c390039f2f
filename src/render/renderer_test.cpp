#include "render/renderer.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"
#include "cache/enhancer.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string errorOf(const Scene& scene) {
    RenderParams params;
    params.integrator = Integrator::Path;
    return drc::errorOf([&] { const Renderer renderer(scene, params, makeIdentityEnhancer(), nullptr); });
}

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

constexpr const char* kLitRoom = R"(
        Film "image" "integer xresolution" 24 "integer yresolution" 16
        LookAt 0 0 -3  0 0 0  0 1 0
        Camera "perspective" "float fov" 70
        WorldBegin
        AttributeBegin
        AreaLightSource "diffuse" "rgb L" [8 8 8]
        Translate 0 1.6 0 Shape "sphere" "float radius" .4
        AttributeEnd
        Material "plastic" "rgb Kd" [.6 .4 .3] "float roughness" .05
        Shape "sphere" "float radius" 1
        ReverseOrientation
        Material "matte"
        Shape "sphere" "float radius" 4
        WorldEnd)";

Image directLayer(RenderParams params) {
    const auto scene = pbrt::loadPbrtString(kLitRoom, ".", {}, "s.pbrt");
    params.spp = 12;
    params.passes = 1;
    Renderer renderer(*scene, params, makeIdentityEnhancer(), nullptr);
    while (renderer.step()) {
    }
    RenderedImage image = renderer.image();
    return image.direct ? std::move(*image.direct) : std::move(image.beauty);
}

// Whatever indirect light the samples bring along: they are the same, and so well distributed.
TEST(Renderer, TheDirectLayerIsWhatTheDirectIntegratorGives) {
    RenderParams params;
    params.integrator = Integrator::Direct;
    const Image direct = directLayer(params);
    params.integrator = Integrator::Drc;
    params.denoise = false;
    const Image layer = directLayer(params);
    for (size_t i = 0; i < direct.data().size(); ++i)
        EXPECT_NEAR(layer.data()[i], direct.data()[i], 1e-5f * (1 + direct.data()[i]));
    params.denoise = true;
    EXPECT_NE(directLayer(params).data(), layer.data());
}

// However late it is, a picture has direct and indirect light everywhere.
TEST(Renderer, ADeadlineThatHasPassedLeavesAWholePicture) {
    const auto scene = pbrt::loadPbrtString(kLitRoom, ".", {}, "s.pbrt");
    for (const Integrator integrator : {Integrator::Drc, Integrator::Path, Integrator::Bdpt}) {
        RenderParams params;
        params.integrator = integrator;
        params.deadline = std::chrono::steady_clock::now();
        Renderer renderer(*scene, params, makeIdentityEnhancer(), nullptr);
        while (renderer.step()) {
        }
        EXPECT_EQ(renderer.samplesDone(), 1);
        EXPECT_EQ(renderer.passesDone(), integrator == Integrator::Drc ? 1 : 0);
        const RenderedImage image = renderer.image();
        if (!image.indirect) continue;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 24; ++x) EXPECT_GT(luminance(image.indirect->rgb(x, y)), 0) << x << " " << y;
    }
}

RenderedImage noisy(Integrator integrator, int spp, uint64_t seed) {
    const auto scene = pbrt::loadPbrtString(kLitRoom, ".", {}, "s.pbrt");
    RenderParams params;
    params.integrator = integrator;
    params.spp = spp;
    params.passes = 1;
    params.seed = seed;
    params.noise = true;
    params.denoise = params.correct = false;
    Renderer renderer(*scene, params, makeIdentityEnhancer(), nullptr);
    while (renderer.step()) {
    }
    return renderer.image();
}

double meanOf(const Image& image) {
    double sum = 0;
    for (const float v : image.data()) sum += v;
    return sum / double(image.data().size());
}

TEST(Renderer, KnowsHowNoisyItIs) {
    for (const Integrator integrator : {Integrator::Path, Integrator::Bdpt, Integrator::Direct}) {
        const RenderedImage few = noisy(integrator, 16, 1), other = noisy(integrator, 16, 2),
                            many = noisy(integrator, 64, 3);
        for (const float n : few.noise->samples.data()) EXPECT_EQ(n, 16);
        const double variance = meanOf(few.noise->variance);
        EXPECT_NEAR(meanOf(many.noise->variance) / variance, 0.25, 0.05);
        if (integrator == Integrator::Bdpt) continue;  // its splats are not counted
        double squares = 0;
        for (size_t i = 0; i < few.beauty.data().size(); ++i)
            squares +=
                double(few.beauty.data()[i] - other.beauty.data()[i]) * (few.beauty.data()[i] - other.beauty.data()[i]);
        const double measured = squares / double(few.beauty.data().size()) / 2;
        // Sobol points do better than independent ones.
        EXPECT_LT(measured, 1.2 * variance);
        EXPECT_GT(measured, 0.1 * variance);
    }
    EXPECT_GT(meanOf(noisy(Integrator::Drc, 16, 1).noise->variance), 0);
}

// The film of the largest size that a file may ask for: no machine has 3.75 TiB for all of it, and any has for a part.
TEST(Renderer, PicturesBeyondTheMemoryAreRefused) {
    const std::string text =
        "Film \"image\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\n"
        "WorldBegin\nShape \"sphere\"\nWorldEnd\n";
    const auto scene = pbrt::loadPbrtString(text, ".", {}, "s.pbrt");
    EXPECT_THAT(
        errorOf(*scene),
        AllOf(StartsWith("s.pbrt:1:6: a picture of 65536 x 65536 pixels needs about 3936.0 GiB of memory, and "),
              HasSubstr("choose a smaller --resolution, or a part of it by --crop")));
    const float part[4] = {0.5f, 0.501f, 0.5f, 0.501f};
    std::copy(part, part + 4, scene->settings.cropWindow);
    EXPECT_EQ(errorOf(*scene), "");
    // What the command line asks for is no fault of the file.
    const auto other = pbrt::loadPbrtString(text, ".", {FilmGeometry{60000, 60000}}, "s.pbrt");
    EXPECT_THAT(errorOf(*other), StartsWith("a picture of 60000 x 60000 pixels needs"));
}

}  // namespace
}  // namespace drc
