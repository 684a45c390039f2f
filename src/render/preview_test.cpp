// What a session shows while it goes on is the beauty of its picture.
#include "film/preview.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "pbrt/scene_file.h"
#include "render/session.h"

namespace drc {
namespace {

std::unique_ptr<Scene> room(bool transparent) {
    const std::string film = transparent ? "\"bool transparent\" \"true\"" : "";
    return pbrt::loadPbrtString("Film \"image\" \"integer xresolution\" 24 \"integer yresolution\" 17 " + film + R"(
        LookAt 0 0 -3  0 0 0  0 1 0
        Camera "perspective" "float fov" 70
        PixelFilter "mitchell"
        WorldBegin
        LightSource "infinite" "rgb L" [.1 .2 .3]
        AttributeBegin
        AreaLightSource "diffuse" "rgb L" [8 8 8]
        Translate 0 1.6 0 Shape "sphere" "float radius" .4
        AttributeEnd
        Material "matte" "rgb Kd" [.6 .4 .3]
        Shape "sphere" "float radius" 1
        WorldEnd)",
                                ".", {}, "s.pbrt");
}

RenderParams params(const std::string& integrator) {
    RenderParams p;
    p.integrator = integrator;
    p.spp = 4;
    p.mapPasses = 1;
    p.gBuffer = p.variance = true;
    return p;
}

void expectTheBeautyOf(const LayeredPicture& picture, const Preview& preview) {
    EXPECT_EQ(preview.beauty.data(), picture.beauty.data());
    EXPECT_EQ(preview.samples.data(), picture.samples->data());
    ASSERT_EQ(preview.alpha.has_value(), picture.alpha.has_value());
    if (preview.alpha) {
        EXPECT_EQ(preview.alpha->data(), picture.alpha->data());
    }
}

class PreviewOf : public testing::TestWithParam<std::string> {};

TEST_P(PreviewOf, IsTheBeautyOfTheSnapshotAfterEachStep) {
    for (const bool transparent : {false, true}) {
        if (transparent && GetParam() == "drc-maps") continue;  // which refuses such films
        const std::unique_ptr<Scene> scene = room(transparent);
        Stats stats;
        Session session(*scene, params(GetParam()), &stats);
        // The first steps sample every fourth pixel, which those between are filled from.
        do {
            SCOPED_TRACE(session.status());
            expectTheBeautyOf(session.snapshot(), session.preview());
        } while (session.step());
        EXPECT_GE(session.samplesDone(), 4);
        const RgbMatrix warmer = whiteBalance({1.2f, 1, .7f});
        LayeredPicture balanced = session.snapshot();
        Preview preview = session.preview();
        balanced.balance(warmer);
        preview.balance(warmer);
        expectTheBeautyOf(balanced, preview);
    }
}

INSTANTIATE_TEST_SUITE_P(Integrators, PreviewOf, testing::ValuesIn(integratorNames()),
                         [](const auto& test) { return test.param == "drc-maps" ? std::string("maps") : test.param; });

TEST(Preview, MayBeTakenWhileAStepRuns) {
    const std::unique_ptr<Scene> scene = room(false);
    Stats stats;
    RenderParams p = params("path");
    p.spp = 64;
    Session session(*scene, p, &stats);
    std::atomic<bool> done = false;
    std::thread render([&] {
        while (session.step()) {
        }
        done = true;
    });
    // Sums are read with their own counts: no pixel is brighter than the light, whatever is added meanwhile.
    int taken = 0;
    do {
        const Preview preview = session.preview();
        ++taken;
        for (int y = 0; y < preview.beauty.height(); ++y)
            for (int x = 0; x < preview.beauty.width(); ++x) {
                EXPECT_LE(preview.samples.at(x, y, 0), 64);
                EXPECT_LE(preview.beauty.rgb(x, y).x, 30) << x << " " << y;
            }
    } while (!done);
    render.join();
    EXPECT_GE(taken, 2);
    expectTheBeautyOf(session.snapshot(), session.preview());
}

}  // namespace
}  // namespace drc
