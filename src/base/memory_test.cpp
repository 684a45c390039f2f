#include "base/memory.h"

#include <gmock/gmock.h>
#include <sys/mman.h>

#include <atomic>
#include <memory>
#include <thread>

#include "base/folder_testing.h"
#include "base/memory_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

constexpr uint64_t kMiB = 1 << 20;

std::string errorOfClaim(double bytes) {
    return errorOf([&] { const MemoryClaim claim(bytes, "the test"); });
}

TEST(Memory, AvailableIsWithinReason) {
    EXPECT_GT(availableMemory(), uint64_t(16) << 20);
    EXPECT_LT(availableMemory(), uint64_t(1) << 50);
}

TEST(Memory, LimitOfTheAddressSpaceCounts) {
    constexpr uint64_t kMore = 64 * kMiB;
    const AddressSpaceLimit limit(kMore);
    const uint64_t left = availableMemory();
    EXPECT_LE(left, kMore);
    EXPECT_GE(left, kMore / 2);
}

TEST(Memory, ClaimsBeyondTheMachineAreRefused) {
    EXPECT_THAT(errorOfClaim(1e18), HasSubstr("the test needs about 931322574.6 GiB of memory, and "));
    EXPECT_EQ(errorOfClaim(4 << 20), "");
    EXPECT_NE(errorOfClaim(double(availableMemory())), "");  // a share of it is kept back
}

TEST(Memory, ClaimsAddUpWhileTheyLive) {
    const double most = 0.6 * double(availableMemory());
    {
        const MemoryClaim first(most, "the first");
        EXPECT_NE(errorOfClaim(most), "");
    }
    EXPECT_EQ(errorOfClaim(most), "");
}

// A claim of 100 of 256 MiB, then, once that has been written to, another of the same size: both fit.
TEST(Memory, WhatHasBeenTakenCountsOnce) {
    const AddressSpaceLimit limit(256 * kMiB);
    constexpr size_t kPart = 100 * kMiB;
    MemoryClaim first(kPart, "the first");
    void* const bytes = mmap(nullptr, kPart, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(bytes, MAP_FAILED);
    EXPECT_NE(errorOfClaim(kPart), "") << "whether it has been written to is not known";
    first.taken(kPart);
    EXPECT_EQ(errorOfClaim(kPart), "");
    EXPECT_NE(errorOfClaim(2 * kPart), "");
    munmap(bytes, kPart);
}

TEST(Memory, ClaimsAreReleasedOnceHoweverTheyAreTaken) {
    const AddressSpaceLimit limit(256 * kMiB);
    for (int i = 0; i < 10; ++i) {
        MemoryClaim claim(100.0 * kMiB, "the test");
        claim.taken(20.0 * kMiB);
        EXPECT_NE(errorOfClaim(160.0 * kMiB), "");
        claim.taken(80.0 * kMiB);
        claim.taken(60.0 * kMiB);  // taken() never shrinks
        EXPECT_EQ(errorOfClaim(160.0 * kMiB), "");
        EXPECT_NE(errorOfClaim(222.0 * kMiB), "");
        claim.taken(1e18);
        EXPECT_EQ(errorOfClaim(222.0 * kMiB), "");
    }
}

TEST(Memory, ManySmallClaimsAreALargeOne) {
    const AddressSpaceLimit limit(32 * kMiB);
    std::string error;
    int claims = 0;
    while (error.empty() && claims < 200) {
        error = errorOfClaim(0.9 * kMiB);
        ++claims;
    }
    EXPECT_THAT(error, HasSubstr("the test, with what came before it, needs about 6"));
    EXPECT_LE(claims, 72);  // fewer if earlier tests left small claims
}

// Two threads that do not exclude each other would collide at least once in this many rounds.
TEST(Memory, OfTwoThreadsOneAloneGetsWhatIsLeft) {
    int passed = 0;
    for (int round = 0; round < 300; ++round) {
        const double most = 0.6 * double(availableMemory());
        std::atomic<int> ready{0}, tried{0}, both{0};
        const auto claim = [&] {
            ++ready;
            while (ready < 2) std::this_thread::yield();
            std::unique_ptr<MemoryClaim> held;
            both += errorOf([&] { held = std::make_unique<MemoryClaim>(most, "the test"); }).empty();
            ++tried;
            while (tried < 2) std::this_thread::yield();
        };
        std::thread other(claim);
        claim();
        other.join();
        EXPECT_LE(both, 1);
        passed += both;
    }
    EXPECT_GT(passed, 0);
}

TEST(Memory, SizesAreReadable) {
    EXPECT_EQ(sizeText(1.5 * (1 << 30)), "1.5 GiB");
    EXPECT_EQ(sizeText(300.0 * (1 << 20)), "300 MiB");
}

}  // namespace
}  // namespace drc
