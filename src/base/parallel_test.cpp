#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
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

// Not even while all threads of the loops are busy does such a loop wait for one of them.
TEST(Parallel, OnThisThreadWaitsForNoOther) {
    const int before = threadCount();
    setThreadCount(2);
    std::atomic<int> busy{0};
    std::atomic<bool> done{false};
    std::thread render([&] {
        parallelFor(0, 64, 1, [&](int, int) {
            ++busy;
            while (!done) std::this_thread::yield();
        });
    });
    while (busy < 2) std::this_thread::yield();
    std::vector<int> pieces;
    onThisThread([&] {
        parallelFor(0, 10, 4, [&, own = std::this_thread::get_id()](int b, int e) {
            EXPECT_EQ(std::this_thread::get_id(), own);
            pieces.insert(pieces.end(), {b, e});
        });
    });
    done = true;
    render.join();
    EXPECT_EQ(pieces, (std::vector<int>{0, 4, 4, 8, 8, 10}));
    // Afterwards loops have help again, also if the body has thrown.
    EXPECT_THROW(onThisThread([] { throw Error("wrong"); }), Error);
    std::atomic<int> together{0};
    parallelFor(0, 2, 1, [&](int, int) {
        ++together;
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (together < 2 && std::chrono::steady_clock::now() < limit) std::this_thread::yield();
    });
    EXPECT_EQ(together, 2);
    setThreadCount(before);
}

TEST(BackgroundTasks, AllAreDoneAfterWaiting) {
    const int before = threadCount();
    for (const int threads : {1, 2, 5}) {
        setThreadCount(threads);
        std::atomic<int> sum{0};
        {
            BackgroundTasks tasks;
            for (int round = 0; round < 2; ++round) {
                for (int i = 1; i <= 100; ++i)
                    tasks.start([&sum, i] { parallelFor(0, i, 1, [&](int b, int e) { sum += e - b; }); });
                // Loops of the caller's own go on meanwhile.
                std::atomic<int> own{0};
                parallelFor(0, 1000, 7, [&](int b, int e) { own += e - b; });
                EXPECT_EQ(own, 1000);
                tasks.wait();
                EXPECT_EQ(sum, 5050 * (round + 1)) << threads;
            }
        }
    }
    setThreadCount(before);
}

TEST(BackgroundTasks, NoMoreThanTheThreadsAtATime) {
    const int before = threadCount();
    setThreadCount(2);
    std::atomic<int> running{0}, most{0};
    {
        BackgroundTasks tasks;
        for (int i = 0; i < 50; ++i)
            tasks.start([&] {
                const int now = ++running;
                for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
                }
                // A task that waits for its own loop must not begin another task.
                parallelFor(0, 64, 1, [](int, int) { std::this_thread::sleep_for(std::chrono::microseconds(20)); });
                --running;
            });
        tasks.wait();
    }
    EXPECT_GE(most, 1);
    EXPECT_LE(most, 2);
    setThreadCount(before);
}

TEST(BackgroundTasks, ThoseLeftAreDroppedAtTheEnd) {
    const int before = threadCount();
    setThreadCount(1);  // so that none begins before the end
    int done = 0;
    {
        BackgroundTasks tasks;
        for (int i = 0; i < 10; ++i) tasks.start([&] { ++done; });
    }
    EXPECT_EQ(done, 0);
    setThreadCount(before);
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
