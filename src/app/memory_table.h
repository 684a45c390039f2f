// Where the memory of a render goes, at the time at which it is most.
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
    // At the start of the program.
    MemoryTable() : program_(processMemory().resident) {}

    // At the ends of the stages of a render: the scene is read and built, rendered, and the picture finished. finishing
    // takes what the process held before.
    void afterBuilding(const Scene& scene);
    void afterRendering(const Session& session, const Stats& stats);
    void beforeFinishing() { beforeFinishing_ = processMemory(); }
    void afterFinishing();

    // The rows of the stage at which the process was largest, in MB, as "memory, MB/..."; the last row before the peak
    // is what the others leave of it: buffers of reading, building and rendering, and memory that has been freed, but
    // not to the system.
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

// The bytes of the meshes that the scene itself holds, each counted once; the accelerator has a copy of its own.
int64_t meshBytes(const Scene& scene);

}  // namespace drc
