// Saves checkpoints during a render.
#pragma once
#include <chrono>
#include <string>

#include "render/checkpoint.h"

namespace drc {

class CheckpointWriter {
  public:
    using Clock = std::chrono::steady_clock;

    // checkpoint: must outlive the writer.
    CheckpointWriter(const Checkpoint& checkpoint, std::string path, Clock::duration every)
        : checkpoint_(checkpoint), path_(std::move(path)), every_(every) {}

    // When the next checkpoint is due.
    Clock::time_point due() const { return last_ + every_; }
    // Saves the state during the render. If that fails, a warning says so, the render goes on, and the last checkpoint
    // stays.
    void save(const Session& session) { save(session, "the render goes on"); }
    // Saves the state at the end of a render.
    void saveLast(const Session& session) { save(session, "the state of the end is not saved"); }
    // How long the latest save took.
    double seconds() const { return seconds_; }
    const std::string& path() const { return path_; }
    // Whether the latest save succeeded.
    bool saved() const { return saved_; }

  private:
    void save(const Session& session, const std::string& otherwise);

    const Checkpoint& checkpoint_;
    std::string path_;
    Clock::duration every_;
    Clock::time_point last_ = Clock::now();
    double seconds_ = 0;
    bool saved_ = false;
};

}  // namespace drc
