#include "base/available_cores.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <cmath>

#include "base/folder_testing.h"

namespace drc {
namespace {

class AvailableCores : public FolderTest {
  protected:
    void write(const std::string& name, const std::string& text) {
        std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
        folder_.write(name, text);
    }
    double quota() const { return quotaOfControlGroups(path("groups"), path("mount")); }
};

TEST_F(AvailableCores, AreNotBoundedWithoutAQuota) {
    EXPECT_TRUE(std::isinf(quota()));
    write("groups", "0::/user.slice/session.scope\n");
    EXPECT_TRUE(std::isinf(quota()));
    write("mount/user.slice/session.scope/cpu.max", "max 100000\n");
    EXPECT_TRUE(std::isinf(quota()));
    write("groups", "4:cpu,cpuacct:/docker/abc\n1:name=systemd:/docker/abc\n");
    write("mount/cpu/docker/abc/cpu.cfs_quota_us", "-1\n");
    write("mount/cpu/docker/abc/cpu.cfs_period_us", "100000\n");
    EXPECT_TRUE(std::isinf(quota()));
}

TEST_F(AvailableCores, AreThoseOfTheGroupAndOfAllAroundIt) {
    write("groups", "0::/farm.slice/job/step\n");
    write("mount/farm.slice/cpu.max", "800000 100000\n");
    EXPECT_EQ(quota(), 8);
    write("mount/farm.slice/job/step/cpu.max", "350000 100000\n");
    EXPECT_EQ(quota(), 3.5);
    write("mount/farm.slice/cpu.max", "50000 100000\n");
    EXPECT_EQ(quota(), 0.5);
}

// The path is the host's, and the group is mounted as the root.
TEST_F(AvailableCores, AreThoseOfTheRootInAContainer) {
    write("groups", "0::/../../docker/abc\n");
    write("mount/cpu.max", "200000 50000\n");
    EXPECT_EQ(quota(), 4);
    write("mount/cpu.max", "max 100000\n");
    write("groups", "7:cpuset:/docker/abc\n3:cpuacct,cpu:/docker/abc\n");
    write("mount/cpuacct,cpu/cpu.cfs_quota_us", "150000\n");
    write("mount/cpuacct,cpu/cpu.cfs_period_us", "100000\n");
    EXPECT_EQ(quota(), 1.5);
}

TEST_F(AvailableCores, AreAtLeastOneAndWithinTheAffinityMask) {
    cpu_set_t all;
    ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
    EXPECT_GE(availableCores(), 1);
    EXPECT_LE(availableCores(), CPU_COUNT(&all));
}

}  // namespace
}  // namespace drc
