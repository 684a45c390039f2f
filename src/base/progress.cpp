#include "base/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace drc {
namespace {

constexpr int kBarWidth = 30;
constexpr int64_t kBarInterval = 100'000'000;  // nanoseconds
constexpr int64_t kLineInterval = 10'000'000'000;

}  // namespace

std::string formatDuration(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0) return "?";
    const auto s = static_cast<int64_t>(std::llround(seconds));
    if (s < 60) return fmt::format("{}s", s);
    if (s < 3600) return fmt::format("{}m{:02}s", s / 60, s % 60);
    return fmt::format("{}h{:02}m", s / 3600, s / 60 % 60);
}

Progress::Progress(std::string title, int64_t total, ProgressMode mode, std::ostream* out)
    : title_(std::move(title)),
      total_(std::max<int64_t>(total, 0)),
      mode_(mode),
      out_(out ? out : &std::cerr),
      start_(Clock::now()) {
    if (mode_ == ProgressMode::Auto) mode_ = !out && isatty(STDERR_FILENO) ? ProgressMode::Bar : ProgressMode::Lines;
    // A job shorter than the interval prints only its final line.
    if (mode_ == ProgressMode::Lines) nextDraw_ = kLineInterval;
}

Progress::~Progress() { finish(); }

void Progress::add(int64_t done) {
    done_.fetch_add(done, std::memory_order_relaxed);
    maybeDraw();
}

void Progress::set(int64_t done) {
    int64_t old = done_.load(std::memory_order_relaxed);
    while (old < done && !done_.compare_exchange_weak(old, done, std::memory_order_relaxed)) {
    }
    maybeDraw();
}

void Progress::setNote(const std::string& note) {
    const std::lock_guard lock(mutex_);
    note_ = note;
}

void Progress::maybeDraw() {
    if (mode_ == ProgressMode::Quiet) return;
    const int64_t now = (Clock::now() - start_) / std::chrono::nanoseconds(1);
    int64_t due = nextDraw_.load(std::memory_order_relaxed);
    if (now < due) return;
    // One thread wins the right to draw; the others continue without waiting.
    const int64_t interval = mode_ == ProgressMode::Bar ? kBarInterval : kLineInterval;
    if (!nextDraw_.compare_exchange_strong(due, now + interval, std::memory_order_relaxed)) return;
    const std::lock_guard lock(mutex_);
    if (!finished_) draw(false);
}

void Progress::draw(bool last) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const double fraction = total_ > 0 ? std::clamp(double(done()) / double(total_), 0.0, 1.0) : 1.0;
    std::string text = title_ + " ";
    if (mode_ == ProgressMode::Bar) {
        const int filled = static_cast<int>(fraction * kBarWidth);
        text += fmt::format("[{:<{}}] ", std::string(static_cast<size_t>(filled), '='), kBarWidth);
    }
    text += fmt::format("{:3.0f}%  {} elapsed", std::floor(fraction * 100), formatDuration(elapsed));
    if (!last && fraction > 0) text += fmt::format(", {} left", formatDuration(elapsed * (1 - fraction) / fraction));
    if (!note_.empty()) text += "  " + note_;
    if (mode_ == ProgressMode::Bar) {
        const size_t length = text.size();
        if (length < lastLength_) text.append(lastLength_ - length, ' ');  // overwrites the rest of a longer line
        lastLength_ = length;
        *out_ << '\r' << text << (last ? "\n" : "") << std::flush;
    } else {
        *out_ << "drc: " << text << '\n' << std::flush;
    }
}

void Progress::finish() {
    if (mode_ == ProgressMode::Quiet) return;
    const std::lock_guard lock(mutex_);
    if (finished_) return;
    finished_ = true;
    draw(true);
}

}  // namespace drc
