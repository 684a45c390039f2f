// Frames in which something else than the camera changes: they take over what stays the same, and no light of the past.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/folder_testing.h"
#include "image/block_means.h"
#include "pbrt/kept_contents.h"
#include "pbrt/scene_file.h"
#include "render/session.h"

namespace drc {
namespace {

// A room with a ball at x, a dim lamp and, if it is on, a bright one.
std::string room(double x, bool on, const std::string& ball = ".7 .2 .1") {
    return fmt::format(R"(
LookAt 0 1.5 -4.5  0 1.2 0  0 1 0
Camera "perspective" "float fov" 60
Film "image" "integer xresolution" 64 "integer yresolution" 48
WorldBegin
AttributeBegin
AreaLightSource "diffuse" "rgb L" [.6 .6 .6]
Shape "trianglemesh" "point P" [-1 2.99 -1  1 2.99 -1  1 2.99 1  -1 2.99 1] "integer indices" [0 1 2 0 2 3]
AttributeEnd
Material "matte" "rgb Kd" [.7 .6 .5]
AttributeBegin
{}
Translate 1.6 2 1
Shape "sphere" "float radius" .15
AttributeEnd
Shape "trianglemesh" "point P" [-3 0 -5  3 0 -5  3 0 3  -3 0 3  -3 3 -5  3 3 -5  3 3 3  -3 3 3]
  "integer indices" [0 1 2 0 2 3  4 6 5 4 7 6  0 3 7 0 7 4  1 5 6 1 6 2  3 2 6 3 6 7  0 5 1 0 4 5]
AttributeBegin
Material "matte" "rgb Kd" [{}]
Translate {} .6 0
Shape "sphere" "float radius" .6
AttributeEnd
WorldEnd
)",
                       on ? "AreaLightSource \"diffuse\" \"rgb L\" [60 40 20]" : "", ball, x);
}

struct Frame {
    std::unique_ptr<const Scene> scene;
    std::unique_ptr<Session> session;
};

RenderParams paramsOf(const std::string& integrator, int spp, uint64_t seed = 1) {
    RenderParams params;
    params.integrator = integrator;
    params.spp = spp;
    params.seed = seed;
    return params;
}

Image finish(Session& session) {
    while (session.step()) {
    }
    return session.picture().beauty;
}

// The picture of the last of several frames, each of which takes over what it can from the one before.
Image lastOf(const std::vector<std::string>& worlds, const RenderParams& params) {
    pbrt::KeptContents kept;
    Frame last;
    Image picture;
    for (const std::string& world : worlds) {
        SessionRemains remains;
        if (last.session) remains = last.session->takeRemains();
        last = {};
        last.scene = pbrt::loadPbrtString(world, ".", {.kept = &kept});
        last.session = std::make_unique<Session>(*last.scene, last.scene->sensor, params, nullptr,
                                                 Schedule::Clock::now(), std::move(remains));
        picture = finish(*last.session);
    }
    return picture;
}

Image alone(const std::string& world, const RenderParams& params) { return lastOf({world}, params); }

TEST(MovingWorld, PathTracedFramesAreWhatTheyAreAlone) {
    const RenderParams params = paramsOf("path", 4);
    const std::vector<std::string> worlds = {room(-1, false), room(-.5, false), room(0, false), room(0, true),
                                             room(0, true, ".1 .1 .9")};
    for (size_t n = 2; n <= worlds.size(); ++n) {
        const std::vector<std::string> some(worlds.begin(), worlds.begin() + std::ptrdiff_t(n));
        EXPECT_EQ(lastOf(some, params).data(), alone(worlds[n - 1], params).data()) << n;
    }
}

// Block means after three frames, beside those of the path tracer.
double worstBlock(const std::vector<std::string>& worlds) {
    constexpr int kBlock = 16;
    const Image expected = blockMeans(alone(worlds.back(), paramsOf("path", 640, 77)), kBlock);
    const Image found = blockMeans(lastOf(worlds, paramsOf("drc", 96)), kBlock);
    double worst = 0;
    for (int y = 0; y < expected.height(); ++y)
        for (int x = 0; x < expected.width(); ++x) {
            const double is = double(luminance(found.rgb(x, y))), should = double(luminance(expected.rgb(x, y)));
            worst = std::max(worst, std::abs(is / should - 1));
        }
    return worst;
}

TEST(MovingWorld, ALampThatIsSwitchedLeavesNoLight) {
    EXPECT_LT(worstBlock({room(0, false), room(0, true), room(.01, true), room(.02, true)}), 0.03);
    EXPECT_LT(worstBlock({room(0, true), room(0, false), room(.01, false), room(.02, false)}), 0.03);
}

// Already in the frame in which it is switched on, where all that is carried is of the dark room.
TEST(MovingWorld, ALampIsSeenAtOnce) { EXPECT_LT(worstBlock({room(0, false), room(0, true)}), 0.03); }

TEST(MovingWorld, ABallThatRollsLeavesNoTrail) {
    EXPECT_LT(worstBlock({room(-1.2, true), room(-.9, true), room(-.6, true), room(-.3, true), room(0, true)}), 0.03);
}

// What was learnt helps: at few samples, the noise is that of more.
TEST(MovingWorld, WhatStaysIsKept) {
    const Image expected = alone(room(.05, true), paramsOf("path", 1024, 77));
    const auto error = [&](const Image& picture) {
        const Image a = blockMeans(picture, 4), b = blockMeans(expected, 4);
        double sum = 0;
        for (size_t i = 0; i < a.data().size(); ++i)
            sum += std::pow(double(a.data()[i] - b.data()[i]) / (double(b.data()[i]) + .1), 2);
        return sum;
    };
    double kept = 0, fresh = 0;
    for (uint64_t seed = 1; seed <= 4; ++seed) {
        const std::vector<std::string> still = {room(.02, true), room(.03, true), room(.04, true), room(.05, true)};
        kept += error(lastOf(still, paramsOf("drc", 4, seed)));
        fresh += error(alone(still.back(), paramsOf("drc", 4, seed)));
    }
    EXPECT_LT(kept, 0.95 * fresh);
}

// A frame that carries cells goes on from a checkpoint to the same bits, in a session that carries none.
TEST(MovingWorld, ACheckpointHasTheCarriedCells) {
    const TemporaryFolder folder;
    const RenderParams params = paramsOf("drc", 12);
    const auto first = pbrt::loadPbrtString(room(0, false)), second = pbrt::loadPbrtString(room(.3, true));
    Session before(*first, params);
    finish(before);
    Session whole(*second, second->sensor, params, nullptr, Schedule::Clock::now(), before.takeRemains());
    for (int i = 0; i < 5; ++i) whole.step();
    whole.save(folder.path("state"), "test");
    Session resumed(*second, params);
    resumed.load(folder.path("state"), "test");
    EXPECT_EQ(finish(resumed).data(), finish(whole).data());
}

}  // namespace
}  // namespace drc
