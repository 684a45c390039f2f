// How long the process has had work for several threads. For the rest of its run time, all cores but one are idle: the
// serial share in Amdahl's law.
#pragma once

namespace drc {

// Its lifetime marks a period with work for several threads: a parallel loop, or a library's own. Sections may be
// nested and may overlap.
class ParallelSection {
  public:
    ParallelSection();
    ~ParallelSection();
    ParallelSection(const ParallelSection&) = delete;
    ParallelSection& operator=(const ParallelSection&) = delete;
};

// Total time in seconds during which at least one section existed. Thread-safe.
double parallelSeconds();

}  // namespace drc
