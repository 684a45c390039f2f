// A token that is raised when a deadline passes or another token is raised, so that loops need to check one flag only.
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/parallel.h"

namespace drc {

class DeadlineToken {
  public:
    // other: may be null.
    DeadlineToken(std::chrono::steady_clock::time_point deadline, const CancelToken* other)
        : watcher_([this, deadline, other](const std::stop_token& stop) {
              std::mutex mutex;
              std::unique_lock lock(mutex);
              std::condition_variable_any stopped;  // ends the wait at once when the token is destroyed
              while (!stop.stop_requested()) {
                  if ((other && other->cancelled()) || std::chrono::steady_clock::now() >= deadline) {
                      token_.cancel();
                      return;
                  }
                  stopped.wait_for(lock, stop, std::chrono::milliseconds(5), [] { return false; });
              }
          }) {}
    const CancelToken& token() const { return token_; }

  private:
    CancelToken token_;
    std::jthread watcher_;
};

}  // namespace drc
