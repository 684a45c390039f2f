#include "base/available_cores.h"

#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace drc {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// The group may use `quota` microseconds of processor time in each period of `period` microseconds. Files with "max" or
// -1 in place of the quota set no limit.
double cores(double quota, double period) { return quota > 0 && period > 0 ? quota / period : kNone; }

// Version 2 stores both numbers in one file.
double quotaV2(const std::filesystem::path& group) {
    std::ifstream file(group / "cpu.max");
    double quota = 0, period = 0;
    return file >> quota >> period ? cores(quota, period) : kNone;
}

double quotaV1(const std::filesystem::path& group) {
    double quota = 0, period = 0;
    return std::ifstream(group / "cpu.cfs_quota_us") >> quota && std::ifstream(group / "cpu.cfs_period_us") >> period
               ? cores(quota, period)
               : kNone;
}

// The least quota of a group and its ancestors, up to the root. path: from /proc/self/cgroup. In a container, this may
// be the host's path; the container's own group then appears as the root.
template <class Quota>
double leastQuota(const std::filesystem::path& root, const std::string& path, const Quota& quotaOf) {
    double least = quotaOf(root);
    std::filesystem::path group = root;
    for (const std::filesystem::path& part : std::filesystem::path(path).relative_path()) {
        group /= part;
        least = std::min(least, quotaOf(group));
    }
    return least;
}

bool hasWord(const std::string& list, const std::string& word) {
    return ("," + list + ",").find("," + word + ",") != std::string::npos;
}

}  // namespace

double quotaOfControlGroups(const std::filesystem::path& groups, const std::filesystem::path& mount) {
    double least = kNone;
    std::ifstream file(groups);
    // Lines are hierarchy:controllers:path; version 2 has the hierarchy 0 and no list of controllers.
    for (std::string line; std::getline(file, line);) {
        const size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
        if (controllers.empty()) least = std::min(least, leastQuota(mount, path, quotaV2));
        if (!hasWord(controllers, "cpu")) continue;
        for (const std::string& folder : {std::string("cpu"), controllers})
            least = std::min(least, leastQuota(mount / folder, path, quotaV1));
    }
    return least;
}

int availableCores() {
    const double most = std::ceil(quotaOfControlGroups("/proc/self/cgroup", "/sys/fs/cgroup"));
    return int(std::max(1.0, std::min(double(tbb::info::default_concurrency()), most)));
}

}  // namespace drc
