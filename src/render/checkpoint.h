// Checkpoints: a render's state in a file, from which it can go on later, to the same bits as one that was never
// stopped.
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

    // Writes it beside the file and puts it in its place. Throws Error, with the old file as it was.
    void save(const Session& session, const std::string& path) const;
    // Continues from it. Throws Error, in one line, if it cannot: what differs, or what is wrong with the file.
    void resume(Session& session, const std::string& path) const;
    // The identity that a file was saved with. Throws Error if it cannot be read, or is no checkpoint.
    static Identity identityOf(const std::string& path);

  private:
    Identity identity_;
};

// The identity of a render: the version of the program, and all settings that the bits of its samples depend on.
// others: settings that params do not have.
Identity identityOf(const RenderSettings& settings, const RenderParams& params, const Identity& others);
// The contents of all files of the scene. Throws Error if a file cannot be read, or if the scene came through a pipe.
Identity checkpointFiles(const Scene& scene);

// "60", "60s", "5m" or "1h" as a time. Throws Error, naming the option, on anything else, and on less than a second.
std::chrono::duration<double> durationOf(const std::string& option, const std::string& text);

}  // namespace drc
