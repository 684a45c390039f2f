// Memory that is asked for before it is taken, so that a file which wants more than there is gets an error, and the
// system does not end the program: Linux grants what it does not have, and kills whoever then uses it.
#pragma once
#include <cstdint>
#include <string>

namespace drc {

// Bytes that this process can still take: what the system has free or could free, within the limits of its control
// group and of `ulimit -v`.
uint64_t availableMemory();

// Holds back the memory of something large for as long as it lives: while that is being made. Claims of several threads
// add up.
class MemoryClaim {
  public:
    // Throws Error "what needs N of memory, and M are available" if it is more than that. Small claims pass, until many
    // of them come to something large together.
    MemoryClaim(double bytes, const std::string& what);
    ~MemoryClaim();
    MemoryClaim(const MemoryClaim&) = delete;
    MemoryClaim& operator=(const MemoryClaim&) = delete;

    // So many of its bytes, in all, have been written to. The system has them no longer, and only the others are held
    // back from now on: whoever does not say so has what it made counted twice, and others are refused what is there.
    void taken(double bytes);

  private:
    uint64_t bytes_ = 0;  // as claimed
    uint64_t held_ = 0;   // of them, what has not been written to
};

// "1.5 GiB", for messages.
std::string sizeText(double bytes);

}  // namespace drc
