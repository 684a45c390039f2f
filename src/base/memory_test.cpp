#include "base/memory.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"

namespace drc {
namespace {

using testing::HasSubstr;

std::string errorOfClaim(double bytes) {
    try {
        const MemoryClaim claim(bytes, "the test");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Memory, AvailableIsWithinReason) {
    EXPECT_GT(availableMemory(), uint64_t(16) << 20);
    EXPECT_LT(availableMemory(), uint64_t(1) << 50);
}

TEST(Memory, LimitOfTheAddressSpaceCounts) {
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &old), 0);
    rlimit small = old;
    uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const uint64_t used = pages * uint64_t(sysconf(_SC_PAGESIZE)), more = uint64_t(64) << 20;
    small.rlim_cur = used + more;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &small), 0);
    const uint64_t left = availableMemory();
    setrlimit(RLIMIT_AS, &old);
    EXPECT_LE(left, more);
    EXPECT_GE(left, more / 2);
}

TEST(Memory, ClaimsBeyondTheMachineAreRefused) {
    EXPECT_THAT(errorOfClaim(1e18), HasSubstr("the test needs about 931322574.6 GiB of memory, and "));
    EXPECT_EQ(errorOfClaim(4 << 20), "");
    EXPECT_NE(errorOfClaim(double(availableMemory())), "");  // a part is kept back
}

TEST(Memory, ClaimsAddUpWhileTheyLive) {
    const double most = 0.6 * double(availableMemory());
    {
        const MemoryClaim first(most, "the first");
        EXPECT_NE(errorOfClaim(most), "");
    }
    EXPECT_EQ(errorOfClaim(most), "");
}

TEST(Memory, SizesAreReadable) {
    EXPECT_EQ(sizeText(1.5 * (1 << 30)), "1.5 GiB");
    EXPECT_EQ(sizeText(300.0 * (1 << 20)), "300 MiB");
}

}  // namespace
}  // namespace drc
