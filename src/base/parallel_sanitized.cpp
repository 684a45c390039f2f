// The loops of parallel.h for the thread sanitizer, on threads that it sees: it does not know oneTBB's own
// synchronization, and would report every loop as a race. Each loop starts its threads anew; loops within loops stay on
// their thread.
#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/available_cores.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/parallel_time.h"

namespace drc {
namespace {

std::atomic<int>& threads() {
    static std::atomic<int> count = availableCores();
    return count;
}

// Whether the calling thread's loops are its own.
bool& isAlone() {
    thread_local bool value = false;
    return value;
}

}  // namespace

void setThreadCount(int count) {
    if (count < 0) throw Error(fmt::format("the number of threads is {}: it must be 0 (all) or more", count));
    threads() = count == 0 ? availableCores() : count;
}

int threadCount() { return threads(); }

void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body, const CancelToken* cancel) {
    const int64_t step = std::max(grain, 1);
    std::atomic<int64_t> next = begin;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        for (;;) {
            const int64_t b = next.fetch_add(step);
            if (b >= end || (cancel && cancel->cancelled())) return;
            try {
                body(int(b), int(std::min<int64_t>(b + step, end)));
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                next = end;
            }
        }
    };
    const int64_t pieces = (int64_t(end) - begin + step - 1) / step;
    if (pieces <= 1 || isAlone()) {
        work();
    } else {
        const ParallelSection section;
        std::vector<std::jthread> others;
        for (int i = 1; i < std::min<int64_t>(threads(), pieces); ++i) others.emplace_back([&] { onThisThread(work); });
        onThisThread(work);
    }
    if (failure) std::rethrow_exception(failure);
}

struct BackgroundTasks::Impl {
    // Works on the tasks until none is left.
    void work() {
        for (;;) {
            std::function<void()> task;
            {
                const std::lock_guard lock(mutex);
                if (waiting.empty()) return;
                task = std::move(waiting.front());
                waiting.pop_front();
            }
            onThisThread(task);
        }
    }
    std::mutex mutex;
    std::deque<std::function<void()>> waiting;
    std::vector<std::jthread> workers;
};

BackgroundTasks::BackgroundTasks() : impl_(std::make_unique<Impl>()) {}

BackgroundTasks::~BackgroundTasks() {
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->waiting.clear();
    }
    wait();
}

void BackgroundTasks::start(std::function<void()> task) {
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->waiting.push_back(std::move(task));
    }
    // As many as there are other threads, each of which may have ended before this task came.
    std::vector<std::jthread>& workers = impl_->workers;
    if (int(workers.size()) >= threads() - 1 && !workers.empty()) workers.erase(workers.begin());  // joins it
    if (int(workers.size()) < threads() - 1) workers.emplace_back([impl = impl_.get()] { impl->work(); });
}

void BackgroundTasks::wait() {
    impl_->work();
    impl_->workers.clear();
}

void isolated(const std::function<void()>& body) { body(); }

void onThisThread(const std::function<void()>& body) {
    struct Restore {
        const bool before = std::exchange(isAlone(), true);
        ~Restore() { isAlone() = before; }
    } const restore;
    body();
}

}  // namespace drc
