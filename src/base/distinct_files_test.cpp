#include "base/distinct_files.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/folder_testing.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class DistinctFilesTest : public FolderTest {
  protected:
    // What is said of a picture `a.exr` and another file; empty if they are apart.
    std::string together(const std::string& other) const {
        DistinctFiles files;
        files.writes("-o", path("a.exr"));
        return errorOf([&] { files.writes("--timing", other); });
    }
};

TEST_F(DistinctFilesTest, OneFileByAnySpellingIsWrittenOnce) {
    fs::create_directory(path("sub"));
    fs::create_symlink("a.exr", path("link.exr"));
    fs::create_symlink(".", path("here"));
    for (const bool exists : {false, true}) {
        if (exists) folder_.write("a.exr", "");
        EXPECT_EQ(together(path("a.exr")), "--timing " + path("a.exr") + ": this is the same file as -o " +
                                               path("a.exr") + ", which is written too; give it another name");
        for (const char* spelling : {"./a.exr", "sub/../a.exr", "link.exr", "here/a.exr", "here//sub/../link.exr"})
            EXPECT_THAT(together(path(spelling)), HasSubstr("the same file")) << spelling << exists;
        EXPECT_EQ(together(path("b.exr")), "");
        EXPECT_EQ(together(path("sub/a.exr")), "");
    }
    fs::create_hard_link(path("a.exr"), path("hard.exr"));
    EXPECT_THAT(together(path("hard.exr")), HasSubstr("the same file"));
}

TEST_F(DistinctFilesTest, RelativePathsAreThoseOfTheProcess) {
    const fs::path before = fs::current_path();
    fs::current_path(dir_);
    EXPECT_THAT(together("a.exr"), HasSubstr("the same file"));
    EXPECT_TRUE(isSameFile("./a.exr", path("a.exr")));
    EXPECT_FALSE(isSameFile("a.exr", ""));
    fs::current_path(before);
}

// In whatever order they come to be known.
TEST_F(DistinctFilesTest, WhatIsReadIsNotWritten) {
    folder_.write("scene.pbrt", "");
    DistinctFiles files;
    files.reads("the scene", path("scene.pbrt"));
    files.reads("the scene's file", path("scene.pbrt"));
    files.writes("-o", path("sky.exr"));
    const std::string tail = "; give it another name";
    EXPECT_EQ(errorOf([&] { files.writes("--timing", path("scene.pbrt")); }),
              "--timing " + path("scene.pbrt") + ": this is the same file as the scene " + path("scene.pbrt") +
                  ", which is read" + tail);
    EXPECT_EQ(errorOf([&] { files.reads("the scene's file", path("sky.exr")); }),
              "-o " + path("sky.exr") + ": this is the same file as the scene's file " + path("sky.exr") +
                  ", which is read" + tail);
}

TEST_F(DistinctFilesTest, DevicesAreWrittenByAll) {
    DistinctFiles files;
    files.writes("--timing", "/dev/null");
    EXPECT_EQ(errorOf([&] { files.writes("--checkpoint", "/dev/null"); }), "");
}

}  // namespace
}  // namespace drc
