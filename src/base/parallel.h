// Parallel loops on oneTBB, and the flag that ends them early.
#pragma once
#include <atomic>
#include <functional>

namespace drc {

// A flag that any thread or signal handler may raise and many threads read often: reading it is one plain load.
class CancelToken {
  public:
    void cancel() { flag_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return flag_.load(std::memory_order_relaxed); }
    void reset() { flag_.store(false, std::memory_order_relaxed); }

  private:
    std::atomic<bool> flag_{false};
    static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may raise it");
};

// How many threads all later loops use, the caller's included; 0: one for each core that the process may run on. May
// exceed the number of cores. Not to be called while a loop runs. Throws Error on a negative count.
void setThreadCount(int count);
int threadCount();

// Calls body(b, e) for the pieces [b, e) of [begin, end), in any order and on any thread. The pieces are begin + k *
// grain to begin + (k + 1) * grain whatever the number of threads, so that results kept per piece do not depend on it.
// The first exception that a body throws ends the loop and is thrown here. Loops may be nested. Once `cancel` is
// raised, no further piece is begun.
void parallelFor(int begin, int end, int grain, const std::function<void(int, int)>& body,
                 const CancelToken* cancel = nullptr);

// Calls the body. A thread that waits in it, for a loop of the body's own or of a library on oneTBB, meanwhile works
// for that loop alone and takes up no piece of a loop around it.
void isolated(const std::function<void()>& body);

}  // namespace drc
