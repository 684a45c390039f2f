#include "base/memory_use.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace drc {
namespace {

TEST(MemoryUse, IsNotedForAsLongAsItIsHeld) {
    const int64_t textures = memoryUse(MemoryUse::Textures), accelerator = memoryUse(MemoryUse::Accelerator);
    {
        NotedMemory a(MemoryUse::Textures, 100);
        EXPECT_EQ(memoryUse(MemoryUse::Textures), textures + 100);
        NotedMemory b = std::move(a);
        EXPECT_EQ(memoryUse(MemoryUse::Textures), textures + 100);
        NotedMemory none;
        none = std::move(b);
        EXPECT_EQ(memoryUse(MemoryUse::Textures), textures + 100);
        EXPECT_EQ(memoryUse(MemoryUse::Accelerator), accelerator);
        none = NotedMemory(MemoryUse::Accelerator, 7);
        EXPECT_EQ(memoryUse(MemoryUse::Textures), textures);
        EXPECT_EQ(memoryUse(MemoryUse::Accelerator), accelerator + 7);
    }
    EXPECT_EQ(memoryUse(MemoryUse::Textures), textures);
    EXPECT_EQ(memoryUse(MemoryUse::Accelerator), accelerator);
}

TEST(MemoryUse, OfTheProcessGrowsByWhatIsWritten) {
    constexpr size_t kBytes = size_t(64) << 20;
    const ProcessMemory before = processMemory();
    ASSERT_GT(before.resident, 0);
    EXPECT_LE(before.resident, before.peak);
    const auto data = std::make_unique_for_overwrite<char[]>(kBytes);
    std::memset(data.get(), 1, kBytes);
    const ProcessMemory after = processMemory();
    EXPECT_NEAR(double(after.resident - before.resident), double(kBytes), 0.1 * double(kBytes))
        << int(data[kBytes / 2]);
    EXPECT_GE(after.peak, after.resident);
}

}  // namespace
}  // namespace drc
