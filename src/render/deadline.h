// Raises a token when a deadline passes or another token is raised, so that loops need to watch one flag alone.
#pragma once
#include <chrono>
#include <optional>
#include <thread>

#include "base/parallel.h"

namespace drc {

class DeadlineToken {
  public:
    DeadlineToken(std::optional<std::chrono::steady_clock::time_point> deadline, const CancelToken& other)
        : watcher_([this, deadline, &other](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  if (other.cancelled() || (deadline && std::chrono::steady_clock::now() >= *deadline)) {
                      token_.cancel();
                      return;
                  }
                  std::this_thread::sleep_for(std::chrono::milliseconds(5));
              }
          }) {}
    const CancelToken& token() const { return token_; }

  private:
    CancelToken token_;
    std::jthread watcher_;
};

}  // namespace drc
