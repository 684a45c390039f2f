// Progress display for long jobs, on standard error.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <mutex>
#include <string>

namespace drc {

enum class ProgressMode {
    Auto,   // a bar if standard error is a terminal, otherwise a line every 10 seconds
    Bar,    // a bar, even if standard error is not a terminal
    Lines,  // a line every 10 seconds
    Quiet,  // nothing
};

// A duration for readers: "59s", "12m05s", "3h07m".
std::string formatDuration(double seconds);

class Progress {
  public:
    // total: in units of the caller's choice (passes, tiles, milliseconds of a budget). out: standard error if null.
    // title is printed before the bar.
    Progress(std::string title, int64_t total, ProgressMode mode = ProgressMode::Auto, std::ostream* out = nullptr);
    ~Progress();  // calls finish()
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Thread-safe and cheap enough to call often: the display is updated at most ten times a second.
    void add(int64_t done = 1);
    // Sets the amount done so far, for jobs that measure it instead of counting. Values below the current one are
    // ignored.
    void set(int64_t done);
    // Sets the text that follows the bar, such as "pass 3".
    void setNote(const std::string& note);
    // Draws the final state and ends the line. An interrupted job shows how far it got, not 100 %.
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
    std::mutex mutex_;                  // guards the members below, note_ and *out_
    size_t lastLength_ = 0;
    bool finished_ = false;
};

}  // namespace drc
