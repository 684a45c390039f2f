// How long the process has had work for several threads. The rest of its life, all cores but one wait: the serial share
// of Amdahl's law.
#pragma once

namespace drc {

// While it lives, there is work for several threads: a parallel loop, or a library's own. May be nested and overlap.
class ParallelSection {
  public:
    ParallelSection();
    ~ParallelSection();
    ParallelSection(const ParallelSection&) = delete;
    ParallelSection& operator=(const ParallelSection&) = delete;
};

// Seconds in which at least one section was alive. Safe from any thread.
double parallelSeconds();

}  // namespace drc
