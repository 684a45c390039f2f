#include "render/checkpoint_writer.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/log.h"

namespace drc {

void CheckpointWriter::save(const Session& session, const std::string& otherwise) {
    const auto start = Clock::now();
    try {
        checkpoint_.save(session, path_);
        saved_ = true;
    } catch (const Error& error) {
        saved_ = false;
        logWarning(fmt::format("--checkpoint: {}; {}", error.what(), otherwise));
    }
    last_ = Clock::now();
    seconds_ = std::chrono::duration<double>(last_ - start).count();
    if (saved_) logDebug(fmt::format("--checkpoint: saved {} in {:.2f} s", path_, seconds_));
}

}  // namespace drc
