#include "base/memory.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <mutex>
#include <optional>

#include "base/error.h"

namespace drc {
namespace {

constexpr uint64_t kUnlimited = std::numeric_limits<uint64_t>::max();
// Asking the system takes about 50 us, too long for each of a million small objects in a file. Claims up to kSmallClaim
// bytes are therefore summed, and checked when the sum reaches kSmallClaims bytes.
constexpr double kSmallClaim = 1 << 20, kSmallClaims = 64 << 20;
// Share of the available memory that claims may use. The rest is for unclaimed allocations: image encoding, Embree and
// other libraries.
constexpr double kShare = 0.9;

// Guards heldBack and smallClaims. Check and claim happen under one lock, so that two threads cannot both claim the
// same memory.
std::mutex claimMutex;
uint64_t heldBack = 0;
double smallClaims = 0;  // sum of the small claims since the system was last asked

// The number at the start of a file. None if the file is missing or begins with a word, such as "max" in control
// groups.
std::optional<uint64_t> numberIn(const std::string& path) {
    std::ifstream in(path);
    uint64_t value = 0;
    return in >> value ? std::optional(value) : std::nullopt;
}

// The value of a line "name:   value kB" in a file such as /proc/meminfo, in bytes.
std::optional<uint64_t> kilobytesOf(const std::string& path, const std::string& name) {
    std::ifstream in(path);
    std::string word;
    uint64_t value = 0;
    while (in >> word) {
        if (word == name && in >> value) return value << 10;
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::nullopt;
}

uint64_t leftOf(std::optional<uint64_t> limit, std::optional<uint64_t> used) {
    if (!limit || !used) return kUnlimited;
    return *limit > *used ? *limit - *used : 0;
}

// Bytes left below the limits of the process's control group, version 2 or 1. In a container, the process's own group
// appears as the root, so both paths are tried.
uint64_t leftInControlGroup() {
    std::string line, own;
    std::ifstream groups("/proc/self/cgroup");
    while (std::getline(groups, line))
        if (line.starts_with("0::")) own = line.substr(3);
    uint64_t left = kUnlimited;
    for (const std::string& path : {own, std::string()}) {
        const std::string folder = "/sys/fs/cgroup" + path;
        left = std::min(left, leftOf(numberIn(folder + "/memory.max"), numberIn(folder + "/memory.current")));
    }
    const std::string old = "/sys/fs/cgroup/memory/memory.";
    return std::min(left, leftOf(numberIn(old + "limit_in_bytes"), numberIn(old + "usage_in_bytes")));
}

}  // namespace

uint64_t availableMemory() {
    uint64_t left = std::min(kilobytesOf("/proc/meminfo", "MemAvailable:").value_or(kUnlimited), leftInControlGroup());
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        left = std::min(left, leftOf(uint64_t(limit.rlim_cur), kilobytesOf("/proc/self/status", "VmSize:")));
    return left;
}

MemoryClaim::MemoryClaim(double bytes, const std::string& what) {
    const std::lock_guard lock(claimMutex);
    const bool isSmall = !(bytes > kSmallClaim);
    if (isSmall) {
        smallClaims += bytes;
        if (smallClaims < kSmallClaims) return;
    }
    const double left = kShare * double(availableMemory()) - double(heldBack), asked = isSmall ? smallClaims : bytes;
    if (asked > left)
        throw Error(fmt::format("{} needs about {} of memory, and {} are available",
                                isSmall ? what + ", with what came before it," : what, sizeText(asked),
                                sizeText(std::max(0.0, left))));
    smallClaims = 0;
    bytes_ = held_ = uint64_t(bytes);
    heldBack += held_;
}

MemoryClaim::~MemoryClaim() { taken(double(bytes_)); }

void MemoryClaim::taken(double bytes) {
    if (held_ == 0) return;
    const uint64_t held = bytes < double(bytes_) ? std::min(held_, bytes_ - uint64_t(bytes)) : 0;
    const std::lock_guard lock(claimMutex);
    heldBack -= held_ - held;
    held_ = held;
}

std::string sizeText(double bytes) {
    constexpr double kGiB = 1 << 30, kMiB = 1 << 20;
    return bytes >= kGiB ? fmt::format("{:.1f} GiB", bytes / kGiB) : fmt::format("{:.0f} MiB", bytes / kMiB);
}

}  // namespace drc
