#include "neural/memory_plan.h"

#include <algorithm>
#include <numeric>

namespace drc {

MemoryPlan planMemory(const std::vector<BufferUse>& uses) {
    MemoryPlan plan;
    plan.offsets.resize(uses.size());
    std::vector<size_t> order(uses.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return uses[a].bytes > uses[b].bytes; });

    const auto aligned = [](size_t n) { return (n + kBufferAlignment - 1) / kBufferAlignment * kBufferAlignment; };
    std::vector<size_t> placed;  // indices of the buffers that already have an offset, sorted by offset
    for (size_t i : order) {
        size_t offset = 0;
        for (size_t j : placed) {
            const bool together = uses[i].firstStep <= uses[j].lastStep && uses[j].firstStep <= uses[i].lastStep;
            if (!together) continue;
            if (offset + uses[i].bytes <= plan.offsets[j]) break;
            offset = std::max(offset, aligned(plan.offsets[j] + uses[j].bytes));
        }
        plan.offsets[i] = offset;
        plan.bytes = std::max(plan.bytes, aligned(offset + uses[i].bytes));
        placed.insert(std::upper_bound(placed.begin(), placed.end(), i,
                                       [&](size_t a, size_t b) { return plan.offsets[a] < plan.offsets[b]; }),
                      i);
    }
    return plan;
}

}  // namespace drc
