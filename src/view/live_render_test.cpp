#include "view/live_render.h"

#include <gtest/gtest.h>

#include <atomic>

#include "base/error.h"
#include "pbrt/scene_file.h"
#include "view/view_camera.h"

namespace drc {
namespace {

constexpr auto kLong = std::chrono::seconds(60);

std::unique_ptr<Scene> ballInARoom() {
    return pbrt::loadPbrtString(
        "LookAt 0 -3 1  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 50\n"
        "Film \"image\" \"integer xresolution\" 48 \"integer yresolution\" 32\nWorldBegin\n"
        "LightSource \"point\" \"point from\" [1 -2 3] \"rgb I\" [9 9 9]\nMaterial \"matte\" \"rgb Kd\" [.5 .6 .7]\n"
        "Shape \"sphere\" \"float radius\" 0.7\nTranslate 0 0 -0.7\nShape \"disk\" \"float radius\" 9\nWorldEnd\n");
}

struct Watched {
    explicit Watched(const std::string& integrator = "path", int spp = 1 << 16)
        : scene(ballInARoom()), session(*scene, params(integrator, spp)) {}
    static RenderParams params(const std::string& integrator, int spp) {
        RenderParams p;
        p.integrator = integrator;
        p.spp = spp;
        p.gBuffer = true;
        return p;
    }
    std::unique_ptr<LiveRender> start() {
        return std::make_unique<LiveRender>(
            session, LiveRender::Callbacks{[this](LayeredPicture&, bool) { ++finished; }, [this] { ++announced; }});
    }
    std::shared_ptr<const LiveFrame> waitFor(const LiveRender& render,
                                             const std::function<bool(const LiveFrame&)>& good) {
        auto frame = render.waitForFrame(0, kLong);
        while (frame && !good(*frame)) frame = render.waitForFrame(frame->number, kLong);
        return frame;
    }

    std::unique_ptr<Scene> scene;
    Session session;
    std::atomic<int> finished{0}, announced{0};
};

TEST(LiveRender, ShowsFramesThatGetBetter) {
    Watched w;
    const auto render = w.start();
    const auto first = render->waitForFrame(0, kLong);
    ASSERT_TRUE(first);
    EXPECT_LE(first->share, 1);
    EXPECT_EQ(first->picture.beauty.width(), 48);
    const auto later = w.waitFor(*render, [](const LiveFrame& f) { return f.samples >= 8; });
    EXPECT_GT(later->number, first->number);
    EXPECT_EQ(later->share, 1);
    EXPECT_GT(later->seconds, first->seconds);
    EXPECT_GE(w.finished, int(later->number));
    // The frame is a picture of its own: it does not change any more.
    const std::vector<float> before = later->picture.beauty.data();
    w.waitFor(*render, [&](const LiveFrame& f) { return f.samples > later->samples + 4; });
    EXPECT_EQ(later->picture.beauty.data(), before);
}

// A render that ends is shown as it is at the end, and has the bits of one that nobody watched.
TEST(LiveRender, EndsWithTheLastPicture) {
    for (const char* integrator : {"path", "drc"}) {
        Watched w(integrator, 6), alone(integrator, 6);
        while (alone.session.step()) {
        }
        const auto render = w.start();
        const auto last = w.waitFor(*render, [](const LiveFrame& f) { return f.samples == 6; });
        EXPECT_EQ(last->picture.beauty.data(), alone.session.picture().beauty.data()) << integrator;
        while (!render->state().done) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_FALSE(render->state().paused);
    }
}

TEST(LiveRender, RestsWhilePaused) {
    Watched w;
    const auto render = w.start();
    w.waitFor(*render, [](const LiveFrame& f) { return f.samples >= 2; });
    render->pause(true);
    EXPECT_TRUE(render->state().paused);
    // Whatever it was at is finished, and shown.
    int samples = 0;
    const auto ask = [&] { render->between([&](const Session& session) { samples = session.samplesDone(); }); };
    ask();
    ask();  // once more, because the last frame is made after the first answer
    const auto resting = render->frame();
    EXPECT_EQ(resting->samples, samples);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(render->frame()->number, resting->number);
    render->pause(false);
    w.waitFor(*render, [&](const LiveFrame& f) { return f.samples > samples; });
}

// Whoever moves the camera of a paused render sees where it goes: one sample, and it rests again.
TEST(LiveRender, ShowsAMovedCameraWhilePaused) {
    Watched w;
    const auto render = w.start();
    w.waitFor(*render, [](const LiveFrame& f) { return f.samples >= 2; });
    render->pause(true);
    const Scene* scene = w.scene.get();
    for (uint64_t i = 1; i <= 3; ++i) {
        ViewCamera camera = ViewCamera::of(*scene->sensor.camera, 3);
        camera.eye.x += 0.05f * float(i);
        render->setCamera([camera, scene] { return camera.place(*scene->sensor.camera, {48, 32}); }, {48, 32}, i < 3);
        w.waitFor(*render, [&](const LiveFrame& f) { return f.view == i && f.samples == 1; });
    }
    EXPECT_TRUE(render->state().paused);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(render->frame()->samples, 1);
    render->pause(false);
    w.waitFor(*render, [](const LiveFrame& f) { return f.samples >= 3; });
}

TEST(LiveRender, FollowsTheCamera) {
    for (const char* integrator : {"path", "drc"}) {
        Watched w(integrator);
        const auto render = w.start();
        w.waitFor(*render, [](const LiveFrame& f) { return f.samples >= 2; });
        ViewCamera camera = ViewCamera::of(*w.scene->sensor.camera, 3);
        const Scene* scene = w.scene.get();
        for (int i = 1; i <= 30; ++i) {
            camera.eye.x += 0.05f;
            const FilmGeometry film{i < 30 ? 24 : 48, i < 30 ? 16 : 32};
            render->setCamera([camera, film, scene] { return camera.place(*scene->sensor.camera, film); }, film,
                              i < 30);
        }
        const auto moved = w.waitFor(
            *render, [](const LiveFrame& f) { return f.view > 0 && f.samples >= 4 && f.picture.beauty.width() == 48; });
        EXPECT_GT(moved->view, 0u);
        // A new session from there sees the same, up to noise.
        Watched fresh(integrator, 64);
        fresh.session.setCamera(camera.place(*fresh.scene->sensor.camera, {48, 32}), {48, 32});
        while (fresh.session.step()) {
        }
        const Image there = fresh.session.picture().beauty;
        double difference = 0, sum = 0;
        for (size_t i = 0; i < there.data().size(); ++i) {
            difference += double(moved->picture.beauty.data()[i] - there.data()[i]);
            sum += double(there.data()[i]);
        }
        EXPECT_LT(std::abs(difference), 0.02 * sum) << integrator;
    }
}

// A camera that moves all the time is seen all the time.
TEST(LiveRender, ShowsFramesWhileTheCameraMoves) {
    Watched w;
    const auto render = w.start();
    render->waitForFrame(0, kLong);
    std::atomic<bool> stop = false;
    const Scene* scene = w.scene.get();
    std::thread mover([&] {
        ViewCamera camera = ViewCamera::of(*scene->sensor.camera, 3);
        while (!stop) {
            camera.eye.x = -camera.eye.x + 0.01f;
            render->setCamera(
                [camera, scene] {
                    return camera.place(*scene->sensor.camera, {48, 32});
                },
                {48, 32}, true);
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    });
    uint64_t views = 0;
    for (int i = 0; i < 20; ++i) {
        const auto frame = render->waitForFrame(render->frame()->number, kLong);
        views = frame->view;
    }
    stop = true;
    mover.join();
    EXPECT_GT(views, 5u);
}

// The error is estimated now and then, of what is seen.
TEST(LiveRender, TellsTheErrorOfThePresentView) {
    const auto scene = ballInARoom();
    RenderParams params = Watched::params("path", 1 << 16);
    params.variance = params.independentHalves = true;
    Session session(*scene, params);
    const auto nothing = [](LayeredPicture&) {};
    std::atomic<int> estimates = 0;
    LiveRender render(session, {.finish = [&](LayeredPicture& picture, bool) { nothing(picture); },
                                .onFrame = [] {},
                                .estimate =
                                    [&](const LayeredPicture& picture) {
                                        ++estimates;
                                        return estimateDenoisedError(picture, nothing);
                                    }});
    const auto waitFor = [&](const std::function<bool(const LiveFrame&)>& good) {
        auto frame = render.waitForFrame(0, kLong);
        for (; !good(*frame); frame = render.waitForFrame(frame->number, kLong))
            EXPECT_TRUE(!frame->error || frame->samples >= 8);
        return frame;
    };
    const auto early = waitFor([](const LiveFrame& f) { return f.error != nullptr; });
    EXPECT_GT(early->error->whole, 0);
    EXPECT_EQ(early->error->local.width(), 48);
    const int first = early->error->samples;
    const auto later = waitFor([&](const LiveFrame& f) { return f.error->samples >= 4 * first; });
    EXPECT_LT(later->error->whole, 0.8 * early->error->whole);
    EXPECT_LT(estimates, later->samples);

    const ViewCamera home = ViewCamera::of(*scene->sensor.camera, 3);
    const FilmGeometry film = scene->sensor.settings.film;
    const uint64_t before = later->view;
    render.setCamera([&] { return home.place(*scene->sensor.camera, film); }, film, false);
    const auto moved = waitFor([&](const LiveFrame& f) { return f.view > before; });
    EXPECT_FALSE(moved->error);
}

// All samples go to a part, also beyond those that the whole picture gets, until the camera moves or it is given up.
TEST(LiveRender, SamplesAPart) {
    Watched w("path", 4);
    const auto render = w.start();
    w.waitFor(*render, [](const LiveFrame& f) { return f.samples == 4; });
    render->setFocus(PicturePart{0.25, 0.5, 0.75, 1});
    const auto focused = w.waitFor(*render, [](const LiveFrame& f) { return f.focusSamples >= 8; });
    EXPECT_EQ(render->state().focus, (PixelRegion{12, 16, 36, 32}));
    EXPECT_EQ(focused->samples, 4);
    EXPECT_EQ(focused->picture.beauty.width(), 48);
    render->setFocus({});
    while (!render->state().done) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(render->state().focus);
    // The least part is a pixel.
    render->setFocus(PicturePart{1, 0, 1, 0});
    // The latest frame may still be one of the focus before.
    while (!render->state().focus) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    w.waitFor(*render, [](const LiveFrame& f) { return f.focusSamples >= 2; });
    EXPECT_EQ(render->state().focus, (PixelRegion{47, 0, 48, 1}));
    const Scene* scene = w.scene.get();
    const ViewCamera camera = ViewCamera::of(*scene->sensor.camera, 3);
    render->setCamera([camera, scene] { return camera.place(*scene->sensor.camera, {48, 32}); }, {48, 32}, false);
    w.waitFor(*render, [](const LiveFrame& f) { return f.view > 0 && f.samples == 4; });
    EXPECT_FALSE(render->state().focus);
}

// It is also known while the render rests, and everybody who watches hears of it.
TEST(LiveRender, TakesAFocusWhilePaused) {
    Watched w;
    const auto render = w.start();
    w.waitFor(*render, [](const LiveFrame& f) { return f.samples >= 2; });
    render->pause(true);
    render->between([](const Session&) {});
    const int before = w.announced;
    render->setFocus(PicturePart{0, 0, 0.5, 0.5});
    while (!render->state().focus) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    while (w.announced == before) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_TRUE(render->state().paused);
}

// A denoiser that would go on for ever is told when the camera moves, and what it has made is not shown.
TEST(LiveRender, EndsWhatIsOutdated) {
    Watched w;
    CancelToken outdated;
    std::atomic<bool> finishing = false;
    int moved = 0;
    LiveRender render(w.session, {.finish =
                                      [&](LayeredPicture&, bool moving) {
                                          // Of the moved frames the first alone is finished.
                                          if (moving && moved++ == 0) return;
                                          finishing = true;
                                          while (!outdated.cancelled())
                                              std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                      },
                                  .onFrame = [] {},
                                  .outdated = &outdated});
    while (!finishing) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const ViewCamera home = ViewCamera::of(*w.scene->sensor.camera, 3);
    const FilmGeometry film = w.scene->sensor.settings.film;
    render.setCamera([&] { return home.place(*w.scene->sensor.camera, film); }, film, true);
    const auto frame = render.waitForFrame(0, kLong);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->number, 1);
    EXPECT_EQ(frame->view, 1);
}

TEST(LiveRender, SaysWhatWentWrong) {
    Watched w;
    LiveRender render(w.session, {[](LayeredPicture&, bool) { throw Error("the denoiser is gone"); }, {}});
    while (render.state().error.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(render.state().error, "the denoiser is gone");
    EXPECT_EQ(render.waitForFrame(0, kLong), nullptr);
    int called = 0;
    render.between([&](const Session&) { ++called; });
    EXPECT_EQ(called, 1);
}

TEST(LiveRender, EndsAtAnyMoment) {
    for (int i = 0; i < 10; ++i) {
        Watched w("drc");
        const auto render = w.start();
        std::this_thread::sleep_for(std::chrono::milliseconds(3 * i));
    }
}

}  // namespace
}  // namespace drc
