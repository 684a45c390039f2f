// How many cores this process may keep busy. A container that was given 4 of 64 cores sees all 64: with a thread for
// each, the system stops all of them for most of the time.
#pragma once
#include <filesystem>

namespace drc {

// The cores of the affinity mask, and no more than the quotas of the process's control groups, rounded up; at least 1.
int availableCores();

// The least quota of a process's control groups and of those around them, in cores; infinity without one. groups: what
// /proc/self/cgroup has. mount: where the control groups are, of version 2 or 1, as /sys/fs/cgroup.
double quotaOfControlGroups(const std::filesystem::path& groups, const std::filesystem::path& mount);

}  // namespace drc
