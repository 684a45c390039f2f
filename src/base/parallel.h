// Parallel loops on oneTBB, and a flag to cancel them.
#pragma once
#include <atomic>
#include <functional>
#include <memory>

namespace drc {

// A flag that any thread or signal handler may raise. Loops read it often, so reading is one plain load.
class CancelToken {
  public:
    void cancel() { flag_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return flag_.load(std::memory_order_relaxed); }
    void reset() { flag_.store(false, std::memory_order_relaxed); }

  private:
    std::atomic<bool> flag_{false};
    static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may raise it");
};

// Sets the number of threads of all later loops, including the calling thread; 0: one per core that the process may
// use. It may exceed the number of cores. Must not be called while a loop runs. Throws Error if negative.
void setThreadCount(int count);
int threadCount();

// Calls body(b, e) for the pieces [b, e) of [begin, end), in any order and on any thread. Piece k is [begin + k *
// grain, begin + (k + 1) * grain), cut off at end, for any number of threads, so that results stored per piece do not
// depend on it. The first exception from a body ends the loop and is rethrown here. Loops may be nested. After `cancel`
// is raised, no further piece begins.
void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body,
                 const CancelToken* cancel = nullptr);

// Calls the body so that a thread that waits inside it, for a parallel loop of its own or of a library on oneTBB, works
// only on that loop and never on a piece of an enclosing loop.
void isolated(const std::function<void()>& body);

// Calls the body so that its loops run on the calling thread alone. For threads outside the pool, which must neither
// wait for a free pool thread nor occupy the pool.
void onThisThread(const std::function<void()>& body);

// Tasks for the pool's other threads while the caller does something else. They begin in any order. The number of
// threads must not change in the meantime.
class BackgroundTasks {
  public:
    BackgroundTasks();
    // Waits for the tasks that have begun, and drops the others.
    ~BackgroundTasks();
    BackgroundTasks(const BackgroundTasks&) = delete;
    BackgroundTasks& operator=(const BackgroundTasks&) = delete;

    // Only one thread may call this at a time. The task must not throw.
    void start(std::function<void()> task);
    // Helps with the tasks until all are done.
    void wait();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drc
