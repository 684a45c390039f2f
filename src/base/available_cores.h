// How many cores this process may keep busy. A container limited to 4 of 64 cores sees all 64; with 64 threads, the
// system would pause all of them for most of the time.
#pragma once
#include <filesystem>

namespace drc {

// The number of cores in the affinity mask, limited by the quotas of the process's control groups, rounded up; at least
// 1.
int availableCores();

// The least quota of the process's control groups and their ancestors, in cores; infinity if there is none. groups:
// path of a file like /proc/self/cgroup. mount: folder of the control groups, version 2 or 1, like /sys/fs/cgroup.
double quotaOfControlGroups(const std::filesystem::path& groups, const std::filesystem::path& mount);

}  // namespace drc
