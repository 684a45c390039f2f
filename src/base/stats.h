// Named counters and timers that threads may add to at any time, and their report.
#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace drc {

// A sum kept in several cache lines, so that threads which add often do not wait for each other.
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

// Time spent, summed over all threads (so it may exceed the clock on the wall), and how often.
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

// Adds the time from its making to its end.
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

// A name is a path: "cache/maps/captured" is printed below "cache" and "maps". Looking a name up takes a lock: in hot
// loops keep the reference, which stays valid as long as the Stats.
class Stats {
  public:
    Counter& counter(const std::string& name);
    Timer& timer(const std::string& name);

    void add(const std::string& name, int64_t n = 1) { counter(name).add(n); }
    // 0 for a counter that does not exist.
    int64_t count(const std::string& name) const;
    // 0 for a timer that does not exist.
    double seconds(const std::string& name) const;

    // A table with aligned columns, sorted by name; times in seconds. Empty if nothing was counted.
    std::string report() const;
    // {"cache": {"maps": {"captured": 12, "time": {"seconds": 0.5, "calls": 12}}}}. A name that is both a value and a
    // group keeps its value under "total" in the group.
    std::string json() const;

  private:
    mutable std::mutex mutex_;
    std::map<std::string, Counter> counters_;  // a map: its elements never move
    std::map<std::string, Timer> timers_;
};

}  // namespace drc
