#include "app/frame_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class FrameListTest : public FolderTest {
  protected:
    FrameList listOf(const std::string& text) {
        folder_.write("frames.txt", text);
        return FrameList(path("frames.txt"));
    }
    std::string out(const char* name) { return path(name); }
};

TEST_F(FrameListTest, HasAFrameInEachLine) {
    FrameList list = listOf("a b.pbrt\t" + out("1.exr") + "\n\nc.pbrt\t" + out("2.exr") + "\t" + out("2.png") + "\r\n");
    auto frame = list.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scene, "a b.pbrt");
    EXPECT_THAT(frame->outputs, ElementsAre(out("1.exr")));
    frame = list.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scene, "c.pbrt");
    EXPECT_THAT(frame->outputs, ElementsAre(out("2.exr"), out("2.png")));
    EXPECT_FALSE(list.next());
    testing::internal::CaptureStdout();
    FrameList::finished(frame->outputs);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), out("2.exr") + "\t" + out("2.png") + "\n");
}

TEST_F(FrameListTest, NamesTheLineThatIsWrong) {
    for (const std::string& line :
         {std::string("a.pbrt"), std::string("a.pbrt\t"), "\t" + out("1.exr"), "a.pbrt\t" + out("1.exr") + "\t\tb.exr"})
        EXPECT_THAT(errorOf([&] { listOf("\n" + line + "\n").next(); }),
                    HasSubstr("frames.txt:2: expected a scene file and, after a tab, the picture to write"))
            << line;
    EXPECT_THAT(errorOf([&] { listOf("a.pbrt\t1.gif\n").next(); }), HasSubstr("1.gif"));
    EXPECT_THAT(errorOf([&] { listOf("a.pbrt\t" + out("none/1.exr")).next(); }), HasSubstr("there is no folder"));
    EXPECT_THAT(errorOf([&] { FrameList(path("none.txt")); }), HasSubstr("cannot read"));
}

}  // namespace
}  // namespace drc
