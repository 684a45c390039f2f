#include "app/command.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace drc {
namespace {

using Clock = std::chrono::steady_clock;
const Clock::time_point initialised = Clock::now();  // after the libraries were joined, before main

TEST(ProcessInfo, StartsBeforeMainAndNotLongBefore) {
    // The kernel's ticks are 10 ms.
    EXPECT_LT(processInfo().start, initialised + std::chrono::milliseconds(10));
    EXPECT_GT(processInfo().start, initialised - std::chrono::minutes(1));
}

TEST(SceneTitle, HasTheFolder) {
    EXPECT_EQ(sceneTitle("/scenes/room/scene.pbrt"), "room/scene.pbrt");
    EXPECT_EQ(sceneTitle("room/scene.pbrt"), "room/scene.pbrt");
    EXPECT_EQ(sceneTitle("a.pbrt"), std::filesystem::current_path().filename() / "a.pbrt");
    EXPECT_EQ(sceneTitle("/a.pbrt"), "a.pbrt");
    EXPECT_EQ(sceneTitle("-"), "standard input");
}

}  // namespace
}  // namespace drc
