#include "view/tev_display.h"

#include <gmock/gmock.h>

#include <atomic>
#include <ctime>

#include "base/log.h"
#include "view/tev_testing.h"

namespace drc {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Extent = TevDisplay::Extent;

// A region of a film that has 40 columns and 30 rows more. Each value tells its place; `add` is added to all.
tev::Picture numbered(int width, int height, float add) {
    tev::Picture picture{{{"", Image(width, height)}, {"depth", Image(width, height, {"Z"})}},
                         {20, 10, 20 + width, 10 + height},
                         {width + 40, height + 30}};
    for (auto& [name, image] : picture.layers)
        for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = float(i % 4099) + add;
    return picture;
}

// What an image that can show it has.
tev::Picture outline(int width, int height) {
    tev::Picture picture = numbered(1, 1, 0);
    picture.region = {20, 10, 20 + width, 10 + height};
    picture.film = {width + 40, height + 30};
    return picture;
}

void expectShown(const test::FakeTev::Shown& shown, const tev::Picture& picture) {
    EXPECT_EQ(shown.width, picture.film.width);
    EXPECT_EQ(shown.height, picture.film.height);
    EXPECT_EQ(shown.channels.size(), tev::channelNames(picture).size());
    for (const auto& [layer, image] : picture.layers)
        for (int c = 0; c < image.channels(); ++c) {
            const std::string& channel = image.channelNames()[size_t(c)];
            // Zeros outside of the region.
            std::vector<float> expected(size_t(shown.width) * size_t(shown.height));
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    expected[size_t(y + picture.region.y0) * size_t(shown.width) + size_t(x + picture.region.x0)] =
                        image.at(x, y, c);
            const auto found = shown.channels.find(layer.empty() ? channel : layer + "." + channel);
            ASSERT_NE(found, shown.channels.end()) << layer << " " << channel;
            EXPECT_EQ(found->second, expected) << layer << " " << channel;
        }
}

// More than the system keeps of what nobody reads.
constexpr int kLarge = 2000;

TevSettings hasty(uint16_t port) {
    TevSettings settings;
    settings.server = {"127.0.0.1", port};
    settings.name = "room";
    settings.interval = settings.retry = 10ms;
    settings.patience = 300ms;
    settings.longest = 60s;  // for what takes its time on a busy machine
    return settings;
}

class TevDisplayTest : public testing::Test {
  protected:
    TevDisplayTest() { forgetWarnings(); }
};

TEST_F(TevDisplayTest, ShowsThePictureAsItRefinesAndTheLastOne) {
    test::FakeTev viewer;
    std::atomic<int> taken = 0;
    TevDisplay display(hasty(viewer.port()), outline(300, 140),
                       [&](Extent) { return numbered(300, 140, float(++taken)); });
    while (taken < 3) std::this_thread::sleep_for(1ms);
    viewer.awaitUpdates(12);
    const tev::Picture last = numbered(300, 140, -1);
    display.finish(last);
    viewer.awaitEnd();
    const auto shown = viewer.image("room");
    expectShown(shown, last);
    EXPECT_GE(shown.updates, 36);  // six tiles of two layers each time
    EXPECT_EQ(viewer.created(), 1);
    EXPECT_EQ(warningCount(), 0);
}

TEST_F(TevDisplayTest, SendsOnlyTilesThatHaveChanged) {
    test::FakeTev viewer;
    std::atomic<int> taken = 0;
    tev::Picture picture = numbered(300, 140, 0);
    // As before the first sample: the second tile, whose columns begin at 128, is black, as the viewer's image is.
    for (auto& [name, image] : picture.layers)
        for (int y = 0; y < 128; ++y)
            for (int x = 128; x < 256; ++x)
                for (int c = 0; c < image.channels(); ++c) image.at(x, y, c) = 0;
    TevDisplay display(hasty(viewer.port()), outline(300, 140), [&](Extent) {
        ++taken;
        return picture;
    });
    while (taken < 4) std::this_thread::sleep_for(1ms);
    display.stopTaking();
    tev::Picture last = picture;
    last.layers[1].image.at(299, 139, 0) += 1;
    display.finish(last);
    viewer.awaitEnd();
    expectShown(viewer.image("room"), last);
    EXPECT_EQ(viewer.image("room").updates, 2 * 5 + 1);
}

TEST_F(TevDisplayTest, TakesTheBeautyMoreOftenThanWhatTakesLong) {
    test::FakeTev viewer;
    std::atomic<int> all = 0, beauties = 0;
    TevDisplay display(hasty(viewer.port()), outline(200, 100), [&](Extent extent) {
        if (extent == Extent::All) {
            ++all;
            timespec begun{}, now{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begun);
            do clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
            while (double(now.tv_sec - begun.tv_sec) + 1e-9 * double(now.tv_nsec - begun.tv_nsec) < 0.03);
            return numbered(200, 100, 1);
        }
        tev::Picture picture = numbered(200, 100, float(++beauties + 1));
        picture.layers[1].name = "unknown";
        return picture;
    });
    while (beauties < 12) std::this_thread::sleep_for(1ms);
    display.stopTaking();
    // Five intervals after the start, and again if pictures of a few pixels took longer than a tenth of a second each.
    EXPECT_GE(all, 1);
    EXPECT_LT(all, beauties / 2);
    viewer.awaitUpdates(2 * 12);
    const test::FakeTev::Shown shown = viewer.image("room");
    EXPECT_EQ(viewer.created(), 1);
    EXPECT_THAT(shown.channels, testing::UnorderedElementsAre(testing::Key("R"), testing::Key("G"), testing::Key("B"),
                                                              testing::Key("depth.Z")));
    const size_t at = 10 * size_t(shown.width) + 20;  // where the region begins
    EXPECT_GE(shown.channels.at("R")[at], 12);
    EXPECT_EQ(shown.channels.at("depth.Z")[at], 1);
    display.finish(numbered(200, 100, -1));
    viewer.awaitEnd();
    expectShown(viewer.image("room"), numbered(200, 100, -1));
}

TEST_F(TevDisplayTest, TakesNothingOnceStopped) {
    test::FakeTev viewer;
    std::atomic<int> taken = 0;
    TevDisplay display(hasty(viewer.port()), outline(3, 2), [&](Extent) {
        ++taken;
        return numbered(3, 2, 0);
    });
    while (taken < 1) std::this_thread::sleep_for(1ms);
    display.stopTaking();
    const int then = taken;
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(taken, then);
}

TEST_F(TevDisplayTest, MakesTheImageAnewWhereTheConnectionBroke) {
    test::FakeTev viewer(0, 500'000);
    TevDisplay display(hasty(viewer.port()), outline(400, 300), [](Extent) { return numbered(400, 300, 0); });
    while (viewer.connections() < 2) std::this_thread::sleep_for(1ms);
    const tev::Picture last = numbered(400, 300, 5);
    display.finish(last);
    viewer.awaitEnd();
    expectShown(viewer.image("room"), last);
    EXPECT_EQ(warningCount(), 1);
}

TEST_F(TevDisplayTest, ShowsTheLastPictureAlthoughTheConnectionBreaks) {
    test::FakeTev viewer(0, 500'000);
    TevSettings settings = hasty(viewer.port());
    settings.interval = 1h;  // only the last picture is sent
    TevDisplay display(settings, outline(1, 1), [](Extent) { return numbered(1, 1, 0); });
    const tev::Picture last = numbered(kLarge, kLarge, 5);
    display.finish(last);
    viewer.awaitEnd();
    expectShown(viewer.image("room"), last);
    EXPECT_EQ(viewer.connections(), 2);
    EXPECT_EQ(warningCount(), 1);
}

TEST_F(TevDisplayTest, ViewersMayComeAndGo) {
    auto viewer = std::make_unique<test::FakeTev>();
    const uint16_t port = viewer->port();
    viewer.reset();
    std::atomic<int> taken = 0;
    TevDisplay display(hasty(port), outline(200, 100), [&](Extent) { return numbered(200, 100, float(++taken)); });
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(taken, 0);
    for (int i = 0; i < 3; ++i) {
        viewer = std::make_unique<test::FakeTev>(port);
        viewer->awaitUpdates(4);
        EXPECT_EQ(viewer->created(), 1);
        if (i < 2) viewer.reset();
    }
    const tev::Picture last = numbered(200, 100, -1);
    display.finish(last);
    viewer->awaitEnd();
    expectShown(viewer->image("room"), last);
    EXPECT_EQ(warningCount(), 1);
}

TEST_F(TevDisplayTest, IsNotHeldUpByAViewerThatDoesNotRead) {
    for (const bool fromTheStart : {false, true}) {
        forgetWarnings();
        test::FakeTev viewer;
        viewer.read(false);
        std::atomic<int> taken = 0;
        const tev::Picture small = numbered(3, 2, 0), large = numbered(kLarge, kLarge, 0);
        const tev::Picture made = fromTheStart ? outline(kLarge, kLarge) : outline(3, 2);
        TevDisplay display(hasty(viewer.port()), made, [&](Extent) {
            ++taken;
            return fromTheStart ? large : small;
        });
        while (taken < 1) std::this_thread::sleep_for(1ms);
        // For longer than its patience, which only matters at the end.
        std::this_thread::sleep_for(500ms);
        EXPECT_EQ(warningCount(), 0);
        const auto start = Clock::now();
        display.stopTaking();
        display.finish(large);
        EXPECT_LT(Clock::now() - start, 10s);
        EXPECT_EQ(warningCount(), 1);
        if (fromTheStart) {
            EXPECT_EQ(taken, 1);
        }
    }
}

TEST_F(TevDisplayTest, TheLatestPictureWins) {
    test::FakeTev viewer;
    viewer.read(false);
    std::atomic<int> taken = 0;
    TevSettings settings = hasty(viewer.port());
    settings.patience = 60s;
    TevDisplay display(settings, outline(kLarge, kLarge),
                       [&](Extent) { return numbered(kLarge, kLarge, float(++taken)); });
    while (taken < 1) std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(200ms);
    const tev::Picture last = numbered(kLarge, kLarge, -1);
    std::thread later([&] {
        std::this_thread::sleep_for(200ms);
        viewer.read(true);
    });
    display.finish(last);
    later.join();
    viewer.awaitEnd();
    expectShown(viewer.image("room"), last);
    // The first picture's 256 tiles of two layers were not all sent.
    EXPECT_LT(viewer.image("room").updates, 512 + 400);
    EXPECT_EQ(taken, 1);
}

TEST_F(TevDisplayTest, WithoutAViewerItWarnsOnce) {
    uint16_t port = 0;
    { port = test::FakeTev().port(); }
    TevDisplay display(hasty(port), outline(3, 2), [](Extent) { return numbered(3, 2, 0); });
    while (warningCount() == 0) std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(warningCount(), 1);
    const auto start = Clock::now();
    display.finish(numbered(3, 2, 0));
    EXPECT_LT(Clock::now() - start, 10s);
    EXPECT_EQ(warningCount(), 1);
}

TEST_F(TevDisplayTest, EndsAtOnceInTheMiddle) {
    test::FakeTev viewer;
    viewer.read(false);
    std::atomic<int> taken = 0;
    const tev::Picture large = numbered(kLarge, kLarge, 0);
    auto start = Clock::now();
    {
        TevDisplay display(hasty(viewer.port()), outline(kLarge, kLarge), [&](Extent) {
            ++taken;
            return large;
        });
        while (taken < 1) std::this_thread::sleep_for(1ms);
        start = Clock::now();
    }
    EXPECT_LT(Clock::now() - start, 10s);
}

TEST_F(TevDisplayTest, LivesWithPicturesThatCannotBeMade) {
    test::FakeTev viewer;
    TevDisplay display(hasty(viewer.port()), outline(3, 2), [](Extent) -> tev::Picture { throw std::bad_alloc(); });
    while (warningCount() == 0) std::this_thread::sleep_for(1ms);
    display.finish(numbered(3, 2, 0));
    EXPECT_EQ(warningCount(), 1);
}

}  // namespace
}  // namespace drc
