#include "neural/memory_plan.h"

#include <gtest/gtest.h>

#include <random>

namespace drc {
namespace {

TEST(MemoryPlan, BuffersAliveTogetherNeverOverlap) {
    std::mt19937 generator(1);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<BufferUse> uses;
        size_t total = 0;
        for (int i = 0; i < 20; ++i) {
            const int first = int(generator() % 30);
            uses.push_back({generator() % 1000, first, first + int(generator() % 6)});
            total += uses.back().bytes + kBufferAlignment;
        }
        const MemoryPlan plan = planMemory(uses);
        EXPECT_LE(plan.bytes, total);
        for (size_t i = 0; i < uses.size(); ++i) {
            EXPECT_EQ(plan.offsets[i] % kBufferAlignment, 0u);
            EXPECT_LE(plan.offsets[i] + uses[i].bytes, plan.bytes);
            for (size_t j = 0; j < i; ++j) {
                if (uses[i].firstStep > uses[j].lastStep || uses[j].firstStep > uses[i].lastStep) continue;
                EXPECT_TRUE(plan.offsets[i] + uses[i].bytes <= plan.offsets[j] ||
                            plan.offsets[j] + uses[j].bytes <= plan.offsets[i]);
            }
        }
    }
}

TEST(MemoryPlan, ReusesWhatIsNoLongerNeeded) {
    const MemoryPlan plan = planMemory({{640, 0, 1}, {640, 1, 2}, {640, 2, 3}, {640, 3, 4}});
    EXPECT_EQ(plan.bytes, 1280u);
}

}  // namespace
}  // namespace drc
