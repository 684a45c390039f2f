// Assigns intermediate results to offsets in one block of memory. Results with disjoint lifetimes share memory, so that
// the working set stays in the cache.
#pragma once
#include <cstddef>
#include <vector>

namespace drc {

struct BufferUse {
    size_t bytes = 0;
    int firstStep = 0, lastStep = 0;  // both inclusive
};

inline constexpr size_t kBufferAlignment = 64;

struct MemoryPlan {
    std::vector<size_t> offsets;  // one per BufferUse, aligned to kBufferAlignment
    size_t bytes = 0;             // size of the whole block
};

// A greedy plan: the largest buffers first, each at the lowest offset that is free during its lifetime.
MemoryPlan planMemory(const std::vector<BufferUse>& uses);

}  // namespace drc
