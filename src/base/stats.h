// Named counters and timers that any thread may add to at any time, and reports of their values.
#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace drc {

// A sum spread over several cache lines, to avoid contention between threads that add often.
class Counter {
  public:
    void add(int64_t n = 1) { shards_[shard()].value.fetch_add(n, std::memory_order_relaxed); }
    int64_t count() const;

  private:
    static constexpr size_t kShards = 16;
    static size_t shard();
    struct alignas(64) Shard {
        std::atomic<int64_t> value{0};
    };
    std::array<Shard, kShards> shards_;
};

// Accumulated time and number of calls. The time is summed over all threads, so it may exceed wall-clock time.
class Timer {
  public:
    void add(std::chrono::nanoseconds t) {
        nanoseconds_.add(t.count());
        calls_.add(1);
    }
    double seconds() const { return double(nanoseconds_.count()) * 1e-9; }
    int64_t calls() const { return calls_.count(); }

  private:
    Counter nanoseconds_, calls_;
};

// Adds the time between its construction and its destruction to a Timer.
class ScopedTimer {
  public:
    explicit ScopedTimer(Timer& timer) : timer_(timer), start_(std::chrono::steady_clock::now()) {}
    ~ScopedTimer() { timer_.add(std::chrono::steady_clock::now() - start_); }
    ScopedTimer(const ScopedTimer&) = delete;
    ScopedTimer& operator=(const ScopedTimer&) = delete;

  private:
    Timer& timer_;
    std::chrono::steady_clock::time_point start_;
};

// A name is a path: "cache/maps/captured" is reported below "cache" and "maps". Looking up a name takes a lock, so hot
// loops should keep the reference, which is valid as long as the Stats object.
class Stats {
  public:
    Counter& counter(const std::string& name);
    Timer& timer(const std::string& name);

    void add(const std::string& name, int64_t n = 1) { counter(name).add(n); }
    // Replaces the counter's value, for numbers that are not sums. Only one thread may call this at a time.
    void set(const std::string& name, int64_t n) { counter(name).add(n - count(name)); }
    // The counter's value; 0 if there is no such counter.
    int64_t count(const std::string& name) const;
    // The timer's seconds; 0 if there is no such timer.
    double seconds(const std::string& name) const;

    // A table with aligned columns, sorted by name, times in seconds. Empty if nothing was counted.
    std::string report() const;
    // report() as JSON: {"cache": {"maps": {"captured": 12, "time": {"seconds": 0.5, "calls": 12}}}}. A name that is
    // both a value and a group stores its value under "total" in the group.
    std::string json() const;

  private:
    mutable std::mutex mutex_;
    std::map<std::string, Counter> counters_;  // std::map, because its elements never move
    std::map<std::string, Timer> timers_;
};

}  // namespace drc
