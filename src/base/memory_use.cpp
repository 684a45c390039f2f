#include "base/memory_use.h"

#include <array>
#include <atomic>
#include <fstream>
#include <limits>
#include <string>

namespace drc {
namespace {

std::atomic<int64_t>& noted(MemoryUse use) {
    static std::array<std::atomic<int64_t>, 2> uses{};
    return uses[size_t(use)];
}

}  // namespace

void addMemoryUse(MemoryUse use, int64_t bytes) { noted(use).fetch_add(bytes, std::memory_order_relaxed); }
int64_t memoryUse(MemoryUse use) { return noted(use).load(std::memory_order_relaxed); }

ProcessMemory processMemory() {
    std::ifstream in("/proc/self/status");
    ProcessMemory memory;
    std::string word;
    while (in >> word) {
        int64_t kilobytes = 0;
        if (word == "VmHWM:" && in >> kilobytes) memory.peak = kilobytes << 10;
        if (word == "VmRSS:" && in >> kilobytes) memory.resident = kilobytes << 10;
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return memory;
}

}  // namespace drc
