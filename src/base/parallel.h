// Parallel loops on oneTBB, and the flag that ends them early.
#pragma once
#include <atomic>
#include <functional>
#include <memory>

namespace drc {

// A flag that any thread or signal handler may raise. It is read often, so reading it is one plain load.
class CancelToken {
  public:
    void cancel() { flag_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return flag_.load(std::memory_order_relaxed); }
    void reset() { flag_.store(false, std::memory_order_relaxed); }

  private:
    std::atomic<bool> flag_{false};
    static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may raise it");
};

// The number of threads of all later loops, including the caller's; 0: one for each core that the process may run on.
// It may exceed the number of cores. Must not be called while a loop runs. Throws Error on a negative count.
void setThreadCount(int count);
int threadCount();

// Calls body(b, e) for the pieces [b, e) of [begin, end), in any order and on any thread. The pieces are begin + k *
// grain to begin + (k + 1) * grain for any number of threads, so that results kept for each piece do not depend on it.
// The first exception that a body throws ends the loop and is rethrown here. Loops may be nested. After `cancel` is
// raised, no further piece is begun.
void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body,
                 const CancelToken* cancel = nullptr);

// Calls the body so that a thread that waits in it, for a parallel loop of the body's own or of a library on oneTBB,
// works for that loop only and takes no piece of an enclosing loop.
void isolated(const std::function<void()>& body);

// Calls the body so that its loops run on the calling thread alone. For a thread beside those of the loops, which must
// not wait until one of these is free, nor take time of all of them.
void onThisThread(const std::function<void()>& body);

// Tasks that the other threads of the loops work on while the caller does something else. They begin in any order. The
// number of threads must not be changed meanwhile.
class BackgroundTasks {
  public:
    BackgroundTasks();
    // Waits for the tasks that have begun; the others are never begun.
    ~BackgroundTasks();
    BackgroundTasks(const BackgroundTasks&) = delete;
    BackgroundTasks& operator=(const BackgroundTasks&) = delete;

    // One thread at a time. The task must not throw.
    void start(std::function<void()> task);
    // Works on the tasks, too, until all are done.
    void wait();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drc
