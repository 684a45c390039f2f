// Where in one arena each intermediate result lives, so that results which are never alive together share memory and
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
    std::vector<size_t> offsets;  // one for each BufferUse, aligned to kBufferAlignment
    size_t bytes = 0;             // of the whole arena
};

// Largest first, each at the lowest offset that is free while it is alive.
MemoryPlan planMemory(const std::vector<BufferUse>& uses);

}  // namespace drc
