#include "render/frame_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "base/error.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class FrameListTest : public FolderTest {
  protected:
    FrameList listOf(const std::string& text) {
        folder_.write("frames.txt", text);
        return FrameList(path("frames.txt"));
    }
    std::string out(const char* name) { return path(name); }
    void writeScenes(const std::vector<std::string>& names) {
        for (const std::string& name : names) folder_.write(name, "");
    }
};

TEST_F(FrameListTest, HasAFrameInEachLine) {
    writeScenes({"a b.pbrt", "c.pbrt"});
    FrameList list = listOf(path("a b.pbrt") + "\t" + out("1.exr") + "\n\n" + path("c.pbrt") + "\t" + out("2.exr") +
                            "\t" + out("2.png") + "\r\n");
    auto frame = list.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scene, path("a b.pbrt"));
    EXPECT_THAT(frame->outputs, ElementsAre(out("1.exr")));
    frame = list.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scene, path("c.pbrt"));
    EXPECT_THAT(frame->outputs, ElementsAre(out("2.exr"), out("2.png")));
    EXPECT_FALSE(list.next());
    testing::internal::CaptureStdout();
    FrameList::finished(frame->outputs);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), out("2.exr") + "\t" + out("2.png") + "\n");
}

TEST_F(FrameListTest, NamesTheLineThatIsWrong) {
    for (const std::string& line :
         {std::string("a.pbrt"), std::string("a.pbrt\t"), "\t" + out("1.exr"), "a.pbrt\t" + out("1.exr") + "\t\tb.exr"})
        EXPECT_THAT(errorOf([&] { listOf("\n" + line + "\n"); }),
                    HasSubstr("frames.txt:2: expected a scene file and, after a tab, the picture to write"))
            << line;
    writeScenes({"a.pbrt"});
    const std::string scene = path("a.pbrt") + "\t";
    EXPECT_THAT(errorOf([&] { listOf(scene + "1.gif\n"); }), HasSubstr("frames.txt:1: -o 1.gif: pictures are"));
    EXPECT_THAT(errorOf([&] { listOf(scene + out("none/1.exr")); }),
                AllOf(HasSubstr("frames.txt:1: -o "), HasSubstr("there is no folder")));
    EXPECT_THAT(errorOf([&] { FrameList(path("none.txt")); }), HasSubstr("cannot read"));
    EXPECT_THAT(errorOf([&] { FrameList(path("")); }), HasSubstr("is a folder"));
}

// What is wrong with the last frame is said before the first one is rendered.
TEST_F(FrameListTest, ChecksAllLinesAtTheStart) {
    writeScenes({"a.pbrt"});
    std::string lines;
    for (int i = 1; i < 200; ++i) lines += path("a.pbrt") + "\t" + out(std::to_string(i).append(".exr").c_str()) + "\n";
    EXPECT_EQ(errorOf([&] { listOf(lines); }), "");
    EXPECT_THAT(errorOf([&] { listOf(lines + path("b.pbrt") + "\t" + out("200.exr")); }),
                AllOf(HasSubstr("frames.txt:200: there is no scene file '"), HasSubstr("b.pbrt'")));
    EXPECT_THAT(errorOf([&] { listOf(lines + path("") + "\t" + out("200.exr")); }),
                AllOf(HasSubstr("frames.txt:200: "), HasSubstr("is a folder, not a scene file")));
    EXPECT_THAT(errorOf([&] { listOf(lines + path("a.pbrt") + "\t" + path("./7.exr")); }),
                AllOf(HasSubstr("frames.txt:200: the picture "), HasSubstr("is that of line 7, too")));
}

TEST_F(FrameListTest, MayHaveAByteOrderMarkAndComments) {
    writeScenes({"a.pbrt"});
    FrameList list =
        listOf("\xEF\xBB\xBF# the walk\n  # from the door\n \n" + path("a.pbrt") + "\t" + out("1.exr") + "\n#end");
    const auto frame = list.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scene, path("a.pbrt"));
    EXPECT_FALSE(list.next());
    FrameList marked = listOf("\xEF\xBB\xBF" + path("a.pbrt") + "\t" + out("1.exr") + "\n");
    EXPECT_EQ(marked.next()->scene, path("a.pbrt"));
}

// A list that is no file may have its next line only when the frame before it is there.
TEST_F(FrameListTest, APipeIsReadLineByLine) {
    writeScenes({"a.pbrt"});
    const std::string pipe = path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::ofstream writer;
    std::thread opening([&] { writer.open(pipe); });
    FrameList list(pipe);
    opening.join();
    writer << path("a.pbrt") << "\t" << out("1.exr") << std::endl;
    EXPECT_EQ(list.next()->scene, path("a.pbrt"));
    writer << path("b.pbrt") << "\t" << out("2.exr") << std::endl;
    EXPECT_THAT(errorOf([&] { list.next(); }), HasSubstr("pipe:2: there is no scene file"));
}

}  // namespace
}  // namespace drc
