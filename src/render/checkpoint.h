// Checkpoints: a render's state in a file, from which the render can continue later, to the same bits as if it had
// never stopped.
#pragma once
#include <chrono>
#include <string>

#include "render/identity.h"
#include "render/session.h"

namespace drc {

class Checkpoint {
  public:
    // identity: the inputs that must match for a render to continue.
    explicit Checkpoint(Identity identity) : identity_(std::move(identity)) {}

    // Writes the session's state beside the file and then replaces the file. Throws Error, and leaves the old file as
    // it was.
    void save(const Session& session, const std::string& path) const;
    // Loads the session's state from the file. Throws Error, in one line, if it cannot: what differs, or what is wrong
    // with the file.
    void resume(Session& session, const std::string& path) const;
    // The identity that a file was saved with. Throws Error if it cannot be read, or is no checkpoint.
    static Identity identityOf(const std::string& path);

  private:
    Identity identity_;
};

// The identity of a render: the version of the program, and all settings that the bits of its samples depend on.
// others: further settings, which params do not contain.
Identity identityOf(const RenderSettings& settings, const RenderParams& params, const Identity& others);
// Checksums of all files of the scene. Throws Error if a file cannot be read, or if the scene came through a pipe.
Identity checkpointFiles(const Scene& scene);

// "60", "60s", "5m" or "1h" as a time. Throws Error, naming the option, on anything else, and on less than a second.
std::chrono::duration<double> durationOf(const std::string& option, const std::string& text);

}  // namespace drc
