#include "app/frame_sequence.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

class FrameSequenceTest : public FolderTest {
  protected:
    FrameSequenceTest() {
        options_.scene = "a.pbrt";
        options_.outputs = {path("a.exr")};
    }
    void list(const std::string& second, const std::string& third) {
        const std::string b = folder_.write("b.pbrt", ""), c = folder_.write("c.pbrt", "");
        options_.frames = folder_.write("frames.txt", b + "\t" + path(second) + "\n" + c + "\t" + path(third) + "\n");
    }
    RenderOptions options_;
};

TEST_F(FrameSequenceTest, OnePictureIsOneFrame) {
    FrameSequence frames(options_);
    EXPECT_FALSE(frames.isAnimation());
    EXPECT_EQ(frames.number(), 1);
    EXPECT_FALSE(frames.next());
    EXPECT_EQ(options_.scene, "a.pbrt");
}

TEST_F(FrameSequenceTest, FramesAreSkippedToACheckpoint) {
    list("b.exr", "c.exr");
    FrameSequence frames(options_);
    testing::internal::CaptureStdout();
    frames.skipTo(3);
    // Whoever waits for their pictures is told that they are there.
    EXPECT_EQ(testing::internal::GetCapturedStdout(), path("a.exr") + "\n" + path("b.exr") + "\n");
    EXPECT_EQ(options_.scene, path("c.pbrt"));
    EXPECT_EQ(options_.outputs, std::vector{path("c.exr")});
    options_.resume = "state";
    EXPECT_EQ(errorOf([&] { frames.skipTo(7); }),
              "--resume state: it is in frame 7, and " + options_.frames + " ends after frame 3");
}

TEST_F(FrameSequenceTest, APictureIsNotReplacedByThatOfALaterFrame) {
    list("b.exr", "./a.exr");
    FrameSequence frames(options_);
    EXPECT_TRUE(frames.next());
    EXPECT_THAT(errorOf([&] { frames.next(); }),
                HasSubstr("frame 3's picture " + path("./a.exr") + ": this is the same file as frame 1's picture"));
    // Two lines of the list are found before anything is rendered.
    list("b.exr", "./b.exr");
    EXPECT_THAT(errorOf([&] { FrameSequence again(options_); }), HasSubstr("is that of line 1, too"));
}

}  // namespace
}  // namespace drc
