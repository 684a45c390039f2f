// Checks large allocations against the available memory in advance, so that a file that requests too much leads to an
// error message. std::bad_alloc does not help: Linux grants allocations that it cannot back, and kills the process when
// the pages are first written to.
#pragma once
#include <cstdint>
#include <string>

namespace drc {

// Bytes that this process can still use: what the system has free or can reclaim, within the limits of the process's
// control group and of `ulimit -v`.
uint64_t availableMemory();

// Reserves memory for a large object while it is built. The reservations of all threads add up.
class MemoryClaim {
  public:
    // Throws Error "<what> needs <N> of memory, and <M> are available" if fewer than `bytes` are available. Small
    // claims are granted without asking the system, until their sum is large.
    MemoryClaim(double bytes, const std::string& what);
    ~MemoryClaim();
    MemoryClaim(const MemoryClaim&) = delete;
    MemoryClaim& operator=(const MemoryClaim&) = delete;

    // Call this once `bytes` of the claim, in total, have been allocated and written to. The system then no longer
    // reports them as available, so only the remainder stays reserved. Without the call they would count twice, and
    // other claims would be refused although memory is available.
    void taken(double bytes);

  private:
    uint64_t bytes_ = 0;  // the whole claim
    uint64_t held_ = 0;   // the part that has not been written to yet
};

// A size for messages: "1.5 GiB" or "12 MiB".
std::string sizeText(double bytes);

}  // namespace drc
