#include "base/parallel_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/parallel.h"

namespace drc {
namespace {

void sleepFor(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

TEST(ParallelTime, CountsOverlappingSectionsOnce) {
    const auto start = std::chrono::steady_clock::now();
    const double before = parallelSeconds();
    {
        const ParallelSection outer;
        const ParallelSection inner;
        sleepFor(0.02);
    }
    const double most = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GE(parallelSeconds() - before, 0.02);
    EXPECT_LE(parallelSeconds() - before, most);
}

TEST(ParallelTime, StandsStillBetweenSections) {
    const double before = parallelSeconds();
    sleepFor(0.02);
    EXPECT_EQ(parallelSeconds(), before);
}

TEST(ParallelTime, CountsLoopsOfSeveralPiecesAlone) {
    double before = parallelSeconds();
    parallelFor(0, 1, 1, [](int, int) { sleepFor(0.01); });
    onThisThread([] { parallelFor(0, 3, 1, [](int, int) { sleepFor(0.01); }); });
    EXPECT_EQ(parallelSeconds(), before);
    before = parallelSeconds();
    parallelFor(0, 2, 1, [](int, int) { sleepFor(0.01); });
    EXPECT_GE(parallelSeconds() - before, 0.01);
}

}  // namespace
}  // namespace drc
