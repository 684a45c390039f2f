// Checks large allocations against the available memory in advance, so that a file which asks for too much gets an
// error message. Linux grants allocations that it cannot back and kills the process when the pages are first touched,
// so std::bad_alloc is no protection.
#pragma once
#include <cstdint>
#include <string>

namespace drc {

// Bytes that this process can still use: what the system has free or can reclaim, within the limits of the process's
// control group and of `ulimit -v`.
uint64_t availableMemory();

// Reserves memory for a large object while it is being built. The reservations of all threads add up.
class MemoryClaim {
  public:
    // Throws Error "<what> needs <N> of memory, and <M> are available" if there is less than `bytes`. Small claims are
    // accepted without asking the system, until together they become large.
    MemoryClaim(double bytes, const std::string& what);
    ~MemoryClaim();
    MemoryClaim(const MemoryClaim&) = delete;
    MemoryClaim& operator=(const MemoryClaim&) = delete;

    // Says that `bytes` of the claim, in total, have been allocated and written to. The system no longer reports those
    // as available, so only the remainder stays reserved. Without this call they would be counted twice, and other
    // claims would be refused memory that exists.
    void taken(double bytes);

  private:
    uint64_t bytes_ = 0;  // the whole claim
    uint64_t held_ = 0;   // the part of it that has not been written to yet
};

// A size for messages: "1.5 GiB" or "12 MiB".
std::string sizeText(double bytes);

}  // namespace drc
