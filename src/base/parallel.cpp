#include "base/parallel.h"

#include <fmt/core.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "base/available_cores.h"
#include "base/error.h"
#include "base/parallel_time.h"

namespace drc {
namespace {

// The default arena never exceeds the number of cores, so a thread count set by the user needs its own arena. The
// global limit applies the count also to libraries that use oneTBB themselves (Embree, oneDNN).
struct Threads {
    explicit Threads(int n)
        : count(n), limit(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(n)), arena(n) {}
    int count;
    tbb::global_control limit;
    tbb::task_arena arena;
};

std::unique_ptr<Threads>& threads() {
    static auto instance = std::make_unique<Threads>(availableCores());
    return instance;
}

// Marks the calling thread, for the lifetime of the object, as working on a piece of a loop inside the arena.
class InArena {
  public:
    InArena() { inside() = true; }
    ~InArena() { inside() = before_; }
    InArena(const InArena&) = delete;
    InArena& operator=(const InArena&) = delete;
    static bool here() { return inside(); }

  private:
    static bool& inside() {
        thread_local bool value = false;
        return value;
    }
    const bool before_ = inside();
};

// Whether loops of the calling thread run on this thread alone (onThisThread).
bool& isAlone() {
    thread_local bool value = false;
    return value;
}

}  // namespace

void setThreadCount(int count) {
    if (count < 0) throw Error(fmt::format("the number of threads is {}: it must be 0 (all) or more", count));
    const int n = count == 0 ? availableCores() : count;
    if (n == threads()->count) return;
    threads().reset();  // the strictest existing limit applies, so remove the old one first
    threads() = std::make_unique<Threads>(n);
}

int threadCount() { return threads()->count; }

void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body, const CancelToken* cancel) {
    if (begin >= end) return;
    const int64_t step = std::max(grain, 1);
    const int64_t pieces = (int64_t(end) - begin + step - 1) / step;
    const auto piece = [&](int64_t k) {
        if (cancel && cancel->cancelled()) return;
        const int64_t b = begin + k * step;
        body(static_cast<int>(b), static_cast<int>(std::min<int64_t>(b + step, end)));
    };
    if (pieces == 1 || isAlone()) {
        for (int64_t k = 0; k < pieces; ++k) piece(k);
        return;
    }
    const auto loop = [&] {
        tbb::parallel_for(
            tbb::blocked_range<int64_t>(0, pieces, 1),
            [&](const tbb::blocked_range<int64_t>& r) {
                const InArena here;
                for (int64_t k = r.begin(); k != r.end(); ++k) piece(k);
            },
            tbb::simple_partitioner());
    };
    // Entering the arena again would end the isolation of an enclosing isolated().
    if (InArena::here()) return loop();
    const ParallelSection section;
    threads()->arena.execute(loop);
}

struct BackgroundTasks::Impl {
    CancelToken cancel;
    tbb::task_group group;
};

BackgroundTasks::BackgroundTasks() : impl_(std::make_unique<Impl>()) {}

BackgroundTasks::~BackgroundTasks() {
    impl_->cancel.cancel();
    wait();
}

void BackgroundTasks::start(std::function<void()> task) {
    threads()->arena.execute([&] {
        impl_->group.run([task = std::move(task), cancel = &impl_->cancel] {
            // isolated(): a thread that waits within the task must not begin another task, because each holds memory of
            // its own.
            if (!cancel->cancelled()) isolated(task);
        });
    });
}

void BackgroundTasks::wait() {
    const ParallelSection section;
    threads()->arena.execute([&] { impl_->group.wait(); });
}

void isolated(const std::function<void()>& body) { tbb::this_task_arena::isolate(body); }

void onThisThread(const std::function<void()>& body) {
    struct Restore {
        const bool before = std::exchange(isAlone(), true);
        ~Restore() { isAlone() = before; }
    } const restore;
    body();
}

}  // namespace drc
