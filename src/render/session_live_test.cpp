// What a live view asks of a session: to follow a camera soon.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "pbrt/scene_file.h"
#include "render/session.h"

namespace drc {
namespace {

std::unique_ptr<Scene> litRoom() {
    return pbrt::loadPbrtString(R"(
        Film "image" "integer xresolution" 96 "integer yresolution" 64
        LookAt 0 0 -3  0 0 0  0 1 0
        Camera "perspective" "float fov" 70
        WorldBegin
        AttributeBegin
        AreaLightSource "diffuse" "rgb L" [8 8 8]
        Translate 0 1.6 0 Shape "sphere" "float radius" .4
        AttributeEnd
        Material "matte" "rgb Kd" [.6 .4 .3]
        Shape "sphere" "float radius" 1
        ReverseOrientation
        Material "matte"
        Shape "sphere" "float radius" 4
        WorldEnd)",
                                ".", {}, "s.pbrt");
}

struct Rendered {
    explicit Rendered(const std::string& integrator, int spp)
        : session(*scene, params(integrator, spp), nullptr, &stats) {}
    static RenderParams params(const std::string& integrator, int spp) {
        RenderParams p;
        p.integrator = integrator;
        p.spp = spp;
        p.gBuffer = p.variance = true;
        return p;
    }
    void finish() {
        while (session.step()) {
        }
    }
    std::unique_ptr<Scene> scene = litRoom();
    Stats stats;
    Session session;
};

bool sameBits(const Film& a, const Film& b) {
    for (size_t i = 0; i < a.layerCount(); ++i)
        for (int y = a.region().y0; y < a.region().y1; ++y)
            if (!std::ranges::equal(a.layer(i).row(y), b.layer(i).row(y))) return false;
    return true;
}

// Wherever a pass is abandoned, nothing of it is left after the camera has been moved.
TEST(LiveSession, AnAbandonedPassLeavesNothing) {
    Rendered fresh("path", 3), moved("path", 3);
    const FilmGeometry film = fresh.scene->settings.film;
    fresh.finish();
    for (int i = 0; i < 20; ++i) {
        while (moved.session.samplesDone() < i % 3) ASSERT_TRUE(moved.session.step());
        CancelToken abandon;
        std::jthread impatient([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(200 * i));
            abandon.cancel();
        });
        moved.session.step(&abandon, &abandon);
        impatient.join();
        moved.session.moveCamera(moved.scene->camera->withFilm(film), film);
        EXPECT_EQ(moved.session.film().passes(), 0);
    }
    moved.finish();
    EXPECT_TRUE(sameBits(fresh.session.film(), moved.session.film()));
}

TEST(LiveSession, AnAbandonedPassDoesNotCount) {
    Rendered r("path", 3);
    CancelToken abandon;
    abandon.cancel();
    EXPECT_FALSE(r.session.step(nullptr, &abandon));
    EXPECT_EQ(r.session.film().passes(), 0);
}

// A camera that moves in a room that the cells know does not wait for them to learn more; where they know little, and
// once each pixel has a sample, they do learn.
TEST(LiveSession, CellsLearnWhenItPays) {
    Rendered r("drc", 64);
    const FilmGeometry film = r.scene->settings.film;
    const auto deposits = [&] { return r.stats.count("cells/deposits"); };
    const auto move = [&] { r.session.moveCamera(r.scene->camera->withFilm(film), film); };
    move();
    ASSERT_TRUE(r.session.step());
    EXPECT_GT(deposits(), 0) << "the cells knew nothing";
    r.finish();
    move();
    const int64_t before = deposits();
    ASSERT_TRUE(r.session.step());
    EXPECT_EQ(deposits(), before) << "the cells knew the room";
    while (r.session.samplesDone() == 0) ASSERT_TRUE(r.session.step());
    EXPECT_GT(deposits(), before);
}

}  // namespace
}  // namespace drc
