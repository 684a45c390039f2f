// The uses of a render's memory at its peak.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/memory_use.h"
#include "base/stats.h"
#include "render/session.h"

namespace drc {

class MemoryTable {
  public:
    // To be called at the start of the program.
    MemoryTable() : program_(processMemory().resident) {}

    // To be called after each stage of a render: building (the scene is read and built), rendering, and finishing the
    // picture; and before finishing, whose memory is the growth since then.
    void afterBuilding(const Scene& scene);
    void afterRendering(const Session& session, const Stats& stats);
    void beforeFinishing() { beforeFinishing_ = processMemory(); }
    void afterFinishing();

    // Adds the rows of the stage with the peak to `stats`, in MB, as "memory, MB/...". The row "other" is what the
    // others leave of the peak: buffers of reading, building and rendering, and memory that has been freed, but not
    // returned to the system.
    void report(Stats& stats) const;

  private:
    using Rows = std::vector<std::pair<std::string, int64_t>>;
    void note(Rows rows);

    int64_t program_;
    int64_t film_ = 0;
    int64_t geometry_ = 0;
    ProcessMemory beforeFinishing_;
    int64_t peak_ = 0;
    Rows rows_;  // at the peak so far
};

// The bytes of the scene's own meshes, each counted once; the accelerator has a copy of its own.
int64_t meshBytes(const Scene& scene);

}  // namespace drc
