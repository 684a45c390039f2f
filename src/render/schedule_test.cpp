#include "render/schedule.h"

#include <gtest/gtest.h>

#include "film/sample_pass.h"

namespace drc {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Kind = Schedule::Work::Kind;
using Clock = Schedule::Clock;

RenderParams params(const std::string& integrator, int spp, int mapPasses, double budget = 0) {
    RenderParams p;
    p.integrator = integrator;
    p.spp = spp;
    p.mapPasses = mapPasses;
    p.seconds = budget;
    p.firstSpacing = 0.1f;
    return p;
}

// The sample passes and map passes that it has run when it stops by itself.
std::pair<int, int> runOut(const Schedule& schedule) {
    int samples = 0, maps = 0;
    while (const auto work = schedule.next(samples, maps)) {
        EXPECT_EQ(work->index, work->kind == Kind::Maps ? maps : samples);
        EXPECT_LT(samples + maps, 1000);
        ++(work->kind == Kind::Maps ? maps : samples);
    }
    return {samples, maps};
}

TEST(Schedule, WithoutABudgetTakesWhatWasAskedFor) {
    EXPECT_EQ(runOut(Schedule(params("path", 5, 0), Clock::now(), 100, 10000)), std::pair(SamplePass::passesFor(5), 0));
    EXPECT_EQ(runOut(Schedule(params("drc-maps", 5, 3), Clock::now(), 100, 10000)),
              std::pair(SamplePass::passesFor(5), 3));
}

TEST(Schedule, PassesAndSamplesGrowInProportion) {
    const Schedule schedule(params("drc-maps", 40, 4), Clock::now(), 100, 10000);
    int samples = 0, maps = 0;
    while (const auto work = schedule.next(samples, maps)) {
        ++(work->kind == Kind::Maps ? maps : samples);
        EXPECT_NEAR(double(maps) / 4, double(SamplePass::wholeSamples(samples)) / 40, 0.3);
    }
}

TEST(Schedule, WithABudgetThereIsAPictureFirst) {
    // The budget is already over.
    const Schedule late(params("drc-maps", 5, 3, 1), Clock::now() - seconds(2), 100, 10000);
    EXPECT_EQ(runOut(late), std::pair(1, 1));
    const Schedule path(params("path", 5, 0, 1), Clock::now() - seconds(2), 100, 10000);
    EXPECT_EQ(runOut(path), std::pair(1, 0));
}

// Whoever asks for no map passes has a picture without them, which an interrupt saves.
TEST(Schedule, APictureWithoutMapPassesIsWholeIfNoneAreWanted) {
    EXPECT_TRUE(Schedule(params("drc-maps", 5, 0), Clock::now(), 100, 10000).hasPicture(1, 0));
    EXPECT_FALSE(Schedule(params("drc-maps", 5, 1), Clock::now(), 100, 10000).hasPicture(1, 0));
    EXPECT_TRUE(Schedule(params("drc-maps", 5, 0, 10), Clock::now(), 100, 10000).hasPicture(1, 0));
    EXPECT_FALSE(Schedule(params("drc-maps", 5, 1, 10), Clock::now(), 100, 10000).hasPicture(1, 0));
}

// Whoever gives both an amount and a time wants whichever comes first.
TEST(Schedule, WithABudgetNoMoreIsDoneThanWasAskedFor) {
    constexpr double kAges = 1e6;
    EXPECT_EQ(runOut(Schedule(params("path", 5, 0, kAges), Clock::now(), 100, 10000)),
              std::pair(SamplePass::passesFor(5), 0));
    EXPECT_EQ(runOut(Schedule(params("drc-maps", 5, 0, kAges), Clock::now(), 100, 10000)),
              std::pair(SamplePass::passesFor(5), 0));
    Schedule maps(params("drc-maps", 5, 3, kAges), Clock::now(), 100, 10000);
    maps.finished({Kind::Samples, 0}, milliseconds(1), true);
    maps.finished({Kind::Maps, 0, 10}, milliseconds(1), true);
    EXPECT_EQ(runOut(maps), std::pair(SamplePass::passesFor(5), 3));
    // The work is done long before the time is over.
    const int all = SamplePass::passesFor(5);
    EXPECT_DOUBLE_EQ(Schedule(params("path", 5, 0, kAges), Clock::now(), 100, 10000).progress(all, 0), 1);
}

TEST(Schedule, TimeIsSetAsideToFinish) {
    Schedule schedule(params("path", 5, 0, 100), Clock::now(), 100, 10000);
    EXPECT_FALSE(schedule.wantsReserve(0, 0));
    EXPECT_TRUE(schedule.wantsReserve(1, 0));
    const auto before = *schedule.deadline();
    schedule.reserve(10);
    schedule.reserveMeasured();
    EXPECT_EQ(before - *schedule.deadline(), seconds(10));
    EXPECT_FALSE(schedule.wantsReserve(5, 0));
    EXPECT_TRUE(schedule.next(5, 0));
    schedule.reserve(101);
    EXPECT_FALSE(schedule.next(5, 0));
    // The load of a machine changes: it is measured again when most of the time is over.
    Schedule old(params("path", 5, 0, 100), Clock::now() - seconds(80), 100, 10000);
    old.reserveMeasured();
    EXPECT_TRUE(old.wantsReserve(5, 0));
    old.reserveMeasured();
    EXPECT_FALSE(old.wantsReserve(5, 0));
}

// A first map pass that would take long lights a lattice of pixels, and its cost is extrapolated for the next ones.
TEST(Schedule, TheFirstMapPassFitsIntoTheTime) {
    Schedule schedule(params("drc-maps", 5, 3, 10), Clock::now(), 2160, 8000000);
    schedule.finished({Kind::Samples, 0}, milliseconds(500), true);
    const auto work = schedule.next(1, 0);
    ASSERT_TRUE(work && work->kind == Kind::Maps);
    EXPECT_EQ(work->stride, 4);
    Schedule quick(params("drc-maps", 5, 3, 10), Clock::now(), 180, 57600);
    quick.finished({Kind::Samples, 0}, milliseconds(4), true);
    EXPECT_EQ(quick.next(1, 0)->stride, 1);
}

TEST(Schedule, ProgressGrowsFromNothingToAll) {
    const Schedule schedule(params("drc-maps", 5, 3), Clock::now(), 100, 10000);
    double last = -1;
    int samples = 0, maps = 0;
    while (const auto work = schedule.next(samples, maps)) {
        EXPECT_GE(schedule.progress(samples, maps), last);
        last = schedule.progress(samples, maps);
        ++(work->kind == Kind::Maps ? maps : samples);
    }
    EXPECT_DOUBLE_EQ(schedule.progress(samples, maps), 1);
}

}  // namespace
}  // namespace drc
