#include "base/per_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

namespace drc {
namespace {

TEST(PerThread, GivesEachThreadItsOwn) {
    PerThread<int> mine([] { return 7; });
    mine.use([](int& value) {
        EXPECT_EQ(value, 7);
        value = 8;
    });
    mine.use([](int& value) { EXPECT_EQ(value, 8); });
    std::thread([&] { mine.use([](int& value) { EXPECT_EQ(value, 7); }); }).join();
}

// A thread that waits for the end of a loop within its piece would take up the next piece of the loop around it.
TEST(PerThread, NoOtherPieceGetsItWhileItsUserWaits) {
    setThreadCount(4);
    PerThread<int> users([] { return 0; });
    std::atomic<int> most{0}, inner{0};
    parallelFor(0, 100, 1, [&](int, int) {
        users.use([&](int& here) {
            if (const int now = ++here; now > most) most = now;
            parallelFor(0, 8, 1, [&](int, int) {
                std::this_thread::sleep_for(std::chrono::microseconds(200));
                ++inner;
            });
            --here;
        });
    });
    setThreadCount(0);
    EXPECT_EQ(most, 1);
    EXPECT_EQ(inner, 800);
}

}  // namespace
}  // namespace drc
