#include "render/frame_sequence.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

class FrameSequenceTest : public FolderTest {
  protected:
    FrameSequenceTest() {
        present_.scene = "a.pbrt";
        present_.outputs = {path("a.exr")};
    }
    void list(const std::string& second, const std::string& third) {
        const std::string b = folder_.write("b.pbrt", ""), c = folder_.write("c.pbrt", "");
        list_ = folder_.write("frames.txt", b + "\t" + path(second) + "\n" + c + "\t" + path(third) + "\n");
    }
    FrameFiles present_;
    std::string list_;
};

TEST_F(FrameSequenceTest, OnePictureIsOneFrame) {
    FrameSequence frames(present_, list_);
    EXPECT_FALSE(frames.isAnimation());
    EXPECT_EQ(frames.number(), 1);
    EXPECT_FALSE(frames.next());
    EXPECT_EQ(present_.scene, "a.pbrt");
}

TEST_F(FrameSequenceTest, FramesAreSkippedToACheckpoint) {
    list("b.exr", "c.exr");
    FrameSequence frames(present_, list_);
    testing::internal::CaptureStdout();
    frames.skipTo(3, "state");
    // Whoever waits for their pictures is told that they are there.
    EXPECT_EQ(testing::internal::GetCapturedStdout(), path("a.exr") + "\n" + path("b.exr") + "\n");
    EXPECT_EQ(present_.scene, path("c.pbrt"));
    EXPECT_EQ(present_.outputs, std::vector{path("c.exr")});
    EXPECT_EQ(errorOf([&] { frames.skipTo(7, "state"); }),
              "--resume state: it is in frame 7, and " + list_ + " ends after frame 3");
}

TEST_F(FrameSequenceTest, APictureIsNotReplacedByThatOfALaterFrame) {
    list("b.exr", "./a.exr");
    FrameSequence frames(present_, list_);
    EXPECT_TRUE(frames.next());
    EXPECT_THAT(errorOf([&] { frames.next(); }),
                HasSubstr("frame 3's picture " + path("./a.exr") + ": this is the same file as frame 1's picture"));
    // Two lines of the list are found before anything is rendered.
    list("b.exr", "./b.exr");
    EXPECT_THAT(errorOf([&] { FrameSequence again(present_, list_); }), HasSubstr("is that of line 1, too"));
}

}  // namespace
}  // namespace drc
