// What a live view asks of a session: to follow a camera soon, and to sample a part of the picture alone.
#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "base/folder_testing.h"
#include "pbrt/scene_file.h"
#include "render/session.h"

namespace drc {
namespace {

std::unique_ptr<Scene> litRoom() {
    return pbrt::loadPbrtString(R"(
        Film "image" "integer xresolution" 48 "integer yresolution" 32
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

constexpr PixelRegion kPart{12, 8, 36, 24};

bool isIn(const PixelRegion& part, int x, int y) { return x >= part.x0 && x < part.x1 && y >= part.y0 && y < part.y1; }

struct Rendered {
    explicit Rendered(const std::string& integrator, int spp, uint64_t seed = 0)
        : session(*scene, params(integrator, spp, seed), &stats) {}
    static RenderParams params(const std::string& integrator, int spp, uint64_t seed) {
        RenderParams p;
        p.seed = seed;
        p.integrator = integrator;
        p.spp = spp;
        p.gBuffer = p.variance = true;
        return p;
    }
    void finish() {
        while (session.step()) {
        }
    }
    void sampleTo(int samples) {
        while (session.samplesDone() < samples) ASSERT_TRUE(session.step());
    }
    void focusFor(int samples) {
        session.setFocus(kPart);
        for (int i = 0; i < samples; ++i) ASSERT_TRUE(session.step());
        EXPECT_EQ(session.focusSamples(), samples);
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
    const FilmGeometry film = fresh.scene->sensor.settings.film;
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
        moved.session.moveCamera(moved.scene->sensor.camera->withFilm(film), film);
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
    const FilmGeometry film = r.scene->sensor.settings.film;
    const auto deposits = [&] { return r.stats.count("cells/deposits"); };
    const auto move = [&] { r.session.moveCamera(r.scene->sensor.camera->withFilm(film), film); };
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

// The part alone gets samples, and goes on where it was when there is no focus any more.
TEST(LiveSession, AFocusTakesAllSamples) {
    Rendered r("path", 6), whole("path", 6);
    r.sampleTo(2);
    const LayeredPicture before = r.session.snapshot();
    r.focusFor(5);
    EXPECT_EQ(r.session.samplesDone(), 2);
    const LayeredPicture focused = r.session.snapshot();
    r.session.setFocus({});
    r.finish();
    whole.finish();
    const LayeredPicture after = r.session.snapshot(), alone = whole.session.snapshot();
    int changed = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const bool inside = isIn(kPart, x, y);
            EXPECT_EQ(focused.samples->at(x, y, 0), inside ? 7 : 2);
            EXPECT_EQ(after.samples->at(x, y, 0), inside ? 11 : 6);
            const bool same = focused.beauty.rgb(x, y) == before.beauty.rgb(x, y);
            if (inside)
                changed += !same;
            else
                EXPECT_TRUE(same && after.beauty.rgb(x, y) == alone.beauty.rgb(x, y)) << x << " " << y;
        }
    EXPECT_GT(changed, int(kPart.count()) / 2);
}

// The samples of a focus are other ones than those before: the noise falls as with so many samples of whole passes, and
// so does what the picture knows of it.
TEST(LiveSession, AFocusRepeatsNoSample) {
    for (const char* integrator : {"path", "drc"}) {
        const auto partOf = [&](uint64_t seed, int samples, int focused, double& variance) {
            Rendered r(integrator, 64, seed);
            r.sampleTo(samples);
            r.focusFor(focused);
            const LayeredPicture picture = r.session.picture();
            const Image known = picture.variance();
            std::vector<double> values;
            for (int y = kPart.y0; y < kPart.y1; ++y)
                for (int x = kPart.x0; x < kPart.x1; ++x) {
                    values.push_back(double(luminance(picture.beauty.rgb(x, y))));
                    variance += double(luminance(known.rgb(x, y)));
                }
            return values;
        };
        struct Noise {
            double squares = 0, known = 0, mean = 0;
        };
        const auto noiseOf = [&](int samples, int focused) {
            Noise noise;
            for (uint64_t seed = 0; seed < 4; ++seed) {
                const std::vector<double> a = partOf(2 * seed + 1, samples, focused, noise.known),
                                          b = partOf(2 * seed + 2, samples, focused, noise.known);
                for (size_t i = 0; i < a.size(); ++i) {
                    noise.squares += (a[i] - b[i]) * (a[i] - b[i]);
                    noise.mean += a[i] + b[i];
                }
            }
            return noise;
        };
        const Noise focused = noiseOf(16, 16), whole = noiseOf(32, 0), few = noiseOf(16, 0);
        EXPECT_GT(few.squares, 1.5 * focused.squares) << integrator;
        // Radiance cells learn more from whole passes.
        if (integrator == std::string("path")) {
            EXPECT_NEAR(focused.squares / whole.squares, 1, 0.3);
            EXPECT_NEAR(focused.known / whole.known, 1, 0.3);
        }
        // And no light is lost or made.
        EXPECT_NEAR(focused.mean / whole.mean, 1, 0.01) << integrator;
    }
}

TEST(LiveSession, AFocusWaitsForTheFirstSampleOfThePicture) {
    Rendered r("path", 6);
    r.session.setFocus(kPart);
    while (r.session.focusSamples() == 0) ASSERT_TRUE(r.session.step());
    EXPECT_EQ(r.session.samplesDone(), 1);
}

// Passes that are cancelled leave their samples, and are not taken again.
TEST(LiveSession, AFocusMayBeCancelledAnywhere) {
    Rendered r("path", 6);
    r.sampleTo(1);
    r.session.setFocus(kPart);
    for (int i = 0; i < 30; ++i) {
        CancelToken cancel;
        std::jthread impatient([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(30 * i));
            cancel.cancel();
        });
        r.session.step(&cancel);
    }
    const LayeredPicture picture = r.session.picture();
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const float samples = picture.samples->at(x, y, 0);
            EXPECT_GE(samples, 1);
            EXPECT_LE(samples, isIn(kPart, x, y) ? 31 : 1);
        }
    CancelToken cancel;
    cancel.cancel();
    EXPECT_FALSE(r.session.step(&cancel));
}

TEST(LiveSession, CellsLearnFromAFocus) {
    Rendered r("drc", 64);
    r.sampleTo(2);
    const int64_t before = r.stats.count("cells/deposits");
    const int enough = int(r.session.film().region().count() / kPart.count()) + 1;
    r.focusFor(enough);
    EXPECT_GT(r.stats.count("cells/deposits"), before);
}

// In small pictures a commit waits for several samples. A move of the camera does not wait for one, unless it is due.
TEST(LiveSession, AMoveKeepsWhatWholeSamplesHaveFoundOut) {
    Rendered r("drc", 9);  // of which the ninth has not been committed
    const FilmGeometry film = r.scene->sensor.settings.film;
    const auto deposits = [&] { return r.stats.count("cells/deposits"); };
    const auto move = [&] { r.session.moveCamera(r.scene->sensor.camera->withFilm(film), film); };
    r.finish();
    const int64_t before = deposits();
    move();
    const int64_t after = deposits();
    EXPECT_GT(after, before);
    move();
    EXPECT_EQ(deposits(), after);
}

TEST(LiveSession, ACameraEndsTheFocus) {
    Rendered r("path", 6), fresh("path", 6);
    const FilmGeometry film = r.scene->sensor.settings.film;
    r.sampleTo(1);
    r.focusFor(3);
    r.session.moveCamera(r.scene->sensor.camera->withFilm(film), film);
    EXPECT_FALSE(r.session.focus());
    r.finish();
    fresh.finish();
    EXPECT_TRUE(sameBits(r.session.film(), fresh.session.film()));
}

TEST(LiveSession, RefusesWhatCannotBe) {
    Rendered r("path", 6);
    for (const PixelRegion& wrong : {PixelRegion{0, 0, 49, 32}, {-1, 0, 5, 5}, {5, 5, 5, 6}, {5, 6, 9, 6}})
        EXPECT_THROW(r.session.setFocus(wrong), std::out_of_range);
    r.sampleTo(1);
    r.focusFor(1);
    const TemporaryFolder folder;
    EXPECT_THROW(r.session.save(folder.path("state"), "room"), std::logic_error);
}

}  // namespace
}  // namespace drc
