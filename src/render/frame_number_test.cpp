#include "render/frame_number.h"

#include <gmock/gmock.h>

#include "base/log.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(FrameNumber, IsAtTheEndOfTheName) {
    EXPECT_EQ(frameNumberOf("frame7.pbrt"), 7);
    EXPECT_EQ(frameNumberOf("a/shot2/shot.0007.pbrt"), 7);
    EXPECT_EQ(frameNumberOf("f_007.pbrt"), 7);
    EXPECT_EQ(frameNumberOf("f_007.pbrt.gz"), 7);
    EXPECT_EQ(frameNumberOf("0123.pbrt"), 123);
    EXPECT_EQ(frameNumberOf("frame_-005.pbrt"), 5);
    EXPECT_EQ(frameNumberOf("frame999999999.pbrt"), 999999999);
}

TEST(FrameNumber, IsMissing) {
    for (const char* name : {"scene.pbrt", "shot7/scene.pbrt", "4th-frame.pbrt", "-", "", "20261128014124.pbrt"})
        EXPECT_EQ(frameNumberOf(name), std::nullopt) << name;
}

std::string saidOf(const std::vector<std::string>& scenes) {
    forgetWarnings();
    testing::internal::CaptureStderr();
    FrameNumbers numbers;
    for (const std::string& scene : scenes) numbers.add(scene);
    return testing::internal::GetCapturedStderr();
}

TEST(FrameNumbers, WarnOnceOfFramesWithTheSameNoise) {
    EXPECT_EQ(saidOf({"a/f1.pbrt", "a/f2.pbrt", "a/last.pbrt"}), "");
    const std::string none = saidOf({"a.pbrt", "b.pbrt", "c.pbrt"});
    EXPECT_THAT(none, AllOf(HasSubstr("a.pbrt and b.pbrt have no number"), HasSubstr("frame1.pbrt")));
    EXPECT_EQ(std::ranges::count(none, '\n'), 1);
    EXPECT_THAT(saidOf({"a/f1.pbrt", "b/f1.pbrt"}), HasSubstr("the same number 1"));
}

}  // namespace
}  // namespace drc
