#include "base/stats.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/parallel.h"

namespace drc {
namespace {

TEST(Stats, CountsFromManyThreads) {
    Stats stats;
    Counter& rays = stats.counter("rays");
    parallelFor(0, 10000, 1, [&](int, int) { rays.add(); });
    stats.add("rays", -1);
    EXPECT_EQ(stats.count("rays"), 9999);
    EXPECT_EQ(stats.count("never"), 0);
    EXPECT_EQ(stats.seconds("never"), 0);
}

TEST(Stats, TimesAScope) {
    Stats stats;
    { const ScopedTimer timer(stats.timer("t")); }
    stats.timer("t").add(std::chrono::seconds(2));
    EXPECT_GE(stats.seconds("t"), 2);
    EXPECT_LT(stats.seconds("t"), 10);
    EXPECT_EQ(stats.timer("t").calls(), 2);
}

TEST(Stats, ReportIsAlignedAndNested) {
    Stats stats;
    EXPECT_EQ(stats.report(), "");
    stats.add("cache/maps", 1234567);
    stats.add("cache/fill", 8);
    stats.timer("cache/time").add(std::chrono::milliseconds(1500));
    stats.add("rays", 12);
    EXPECT_EQ(stats.report(),
              "cache\n"
              "  fill          8\n"
              "  maps  1,234,567\n"
              "  time      1.500 s, 1 calls\n"
              "rays           12\n");
}

TEST(Stats, Json) {
    Stats stats;
    stats.add("a \"b\"/c", 3);
    stats.add("rays", 5);
    stats.add("rays/shadow", 2);
    stats.timer("rays").add(std::chrono::seconds(1));
    const auto json = nlohmann::json::parse(stats.json());
    EXPECT_EQ(json["a \"b\""]["c"], 3);
    EXPECT_EQ(json["rays"]["shadow"], 2);
    EXPECT_EQ(json["rays"]["total"]["seconds"], 1.0);
}

}  // namespace
}  // namespace drc
