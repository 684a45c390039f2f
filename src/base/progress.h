// Shows how far a long job is, on standard error.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <mutex>
#include <string>

namespace drc {

enum class ProgressMode {
    Auto,   // a bar if standard error is a terminal, else a line every 10 seconds
    Bar,    // a bar wherever it goes
    Lines,  // a line every 10 seconds
    Quiet,  // nothing
};

// "59s", "12m05s", "3h07m": for people.
std::string formatDuration(double seconds);

class Progress {
  public:
    // total: in units of the caller's choice (passes, tiles, milliseconds of a budget). out: standard error if null.
    Progress(std::string title, int64_t total, ProgressMode mode = ProgressMode::Auto, std::ostream* out = nullptr);
    ~Progress();  // finishes
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // From any thread, as often as wanted: it draws at most ten times a second.
    void add(int64_t done = 1);
    // Sets what is done so far; for jobs that measure it instead of counting. It may not go back.
    void set(int64_t done);
    // Replaces what follows the bar, as "pass 3".
    void setNote(const std::string& note);
    // Draws the last state and ends the line. What was not reached stays visible: an interrupted job shows no 100 %.
    void finish();

    int64_t done() const { return done_.load(std::memory_order_relaxed); }

  private:
    using Clock = std::chrono::steady_clock;
    void maybeDraw();
    void draw(bool last);

    std::string title_, note_;
    int64_t total_;
    ProgressMode mode_;
    std::ostream* out_;
    Clock::time_point start_;
    std::atomic<int64_t> done_{0};
    std::atomic<int64_t> nextDraw_{0};  // nanoseconds since start_
    std::mutex mutex_;                  // guards what follows, note_ and *out_
    size_t lastLength_ = 0;
    bool finished_ = false;
};

}  // namespace drc
