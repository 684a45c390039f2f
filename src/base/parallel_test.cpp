#include "base/parallel.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <stdexcept>
#include <vector>

#include "base/error.h"

namespace drc {
namespace {

TEST(Parallel, VisitsEveryIndexOnce) {
    for (const int grain : {1, 7, 1000}) {
        std::vector<std::atomic<int>> visits(997);
        parallelFor(-3, 994, grain, [&](int b, int e) {
            for (int i = b; i < e; ++i) ++visits[static_cast<size_t>(i + 3)];
        });
        for (const auto& v : visits) EXPECT_EQ(v, 1);
    }
}

TEST(Parallel, PiecesDoNotDependOnTheThreadCount) {
    const auto pieces = [](int threads) {
        setThreadCount(threads);
        std::mutex mutex;
        std::set<std::pair<int, int>> seen;
        parallelFor(0, 103, 10, [&](int b, int e) {
            const std::lock_guard lock(mutex);
            seen.insert({b, e});
        });
        setThreadCount(0);
        return seen;
    };
    const auto one = pieces(1);
    EXPECT_EQ(one.size(), 11u);
    EXPECT_TRUE(one.count({100, 103}));
    EXPECT_EQ(one, pieces(5));
}

TEST(Parallel, ThrowsWhatTheBodyThrows) {
    EXPECT_THROW(parallelFor(0, 100, 1,
                             [](int b, int) {
                                 if (b == 42) throw Error("x");
                             }),
                 Error);
    EXPECT_THROW(parallelFor(0, 1, 1, [](int, int) { throw std::out_of_range("x"); }), std::out_of_range);
}

TEST(Parallel, NestsAndAcceptsAnEmptyRange) {
    std::atomic<int> sum{0};
    parallelFor(0, 10, 1, [&](int, int) { parallelFor(0, 10, 3, [&](int b, int e) { sum += e - b; }); });
    EXPECT_EQ(sum, 100);
    parallelFor(5, 5, 1, [](int, int) { FAIL(); });
    parallelFor(5, 2, 1, [](int, int) { FAIL(); });
}

TEST(Parallel, StopsWhenCancelled) {
    setThreadCount(1);
    CancelToken cancel;
    int calls = 0;
    parallelFor(
        0, 100, 1,
        [&](int, int) {
            if (++calls == 3) cancel.cancel();
        },
        &cancel);
    EXPECT_EQ(calls, 3);
    setThreadCount(0);
}

TEST(Parallel, ThreadCount) {
    setThreadCount(3);
    EXPECT_EQ(threadCount(), 3);
    EXPECT_THROW(setThreadCount(-1), Error);
    EXPECT_EQ(threadCount(), 3);
    setThreadCount(0);
    EXPECT_GE(threadCount(), 1);
}

}  // namespace
}  // namespace drc
