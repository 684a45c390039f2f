// Renders whose pictures cannot be written where they should, or would replace what must stay, as a user sees them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/image_io.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LostPicture : public FolderTest {
  protected:
    LostPicture() {
        Image sky(8, 8);
        std::ranges::fill(sky.data(), 1.f);
        writeExr(path("sky.exr"), sky);
        folder_.write("scene/room.pbrt", R"(
LookAt 0 0 -3  0 0 0  0 1 0
Camera "perspective" "float fov" 60
Film "image" "integer xresolution" 32 "integer yresolution" 32
WorldBegin
LightSource "infinite" "string mapname" "../sky.exr"
LightSource "point"
Shape "sphere" "float radius" 1
WorldEnd
)");
    }

    // The exit code of `drc render` in the folder, by a shell: words may be quoted, and before: commands that come
    // first.
    int render(const std::string& words, const std::string& before = "") const {
        const std::string command = "cd " + path("") + "; " + before + DRC_PROGRAM +
                                    " render scene/room.pbrt --denoise off --spp 2 --nthreads 1 " + words +
                                    " 2> said.txt";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    std::string said() const { return readFile(path("said.txt")); }
    // What is said of words that are refused before the scene is rendered.
    std::string refusal(const std::string& words) const {
        EXPECT_EQ(render(words), 1) << words << said();
        EXPECT_THAT(said(), testing::Not(HasSubstr("elapsed"))) << words;
        return said();
    }
    bool exists(const std::string& name) const { return fs::exists(path(name)); }
};

TEST_F(LostPicture, WhatCannotBeWrittenIsSaidFirst) {
    fs::create_directory(path("folder.exr"));
    EXPECT_THAT(refusal("-o folder.exr"), HasSubstr("-o: cannot write folder.exr: Is a directory"));
    EXPECT_THAT(refusal("-o " + std::string(296, 'n') + ".exr"), HasSubstr("File name too long"));
    EXPECT_THAT(refusal("-o /proc/a.exr"), HasSubstr("cannot write /proc/a.exr"));
    EXPECT_THAT(refusal("-o a.exr --timing folder.exr"), HasSubstr("--timing: cannot write"));
    EXPECT_THAT(refusal("-o a.exr --checkpoint folder.exr"), HasSubstr("--checkpoint: cannot write"));
    // Also where the film names the picture.
    EXPECT_THAT(refusal("-D film.filename=folder.exr"), HasSubstr("cannot write folder.exr"));
    // Nothing fits on a disk that is full.
    EXPECT_EQ(render("-o a.exr", "ulimit -f 0; "), 1);
    EXPECT_FALSE(exists("a.exr"));
}

TEST_F(LostPicture, WhatCannotBeWrittenAtTheEndIsElsewhere) {
    fs::create_symlink("/dev/full", path("full.exr"));
    EXPECT_EQ(render("-o full.exr -o good.png --timing timing.json --checkpoint state"), 1);
    EXPECT_THAT(said(),
                HasSubstr("cannot write full.exr: No space left on device; the picture is in full.rescued.exr"));
    EXPECT_THAT(said(), HasSubstr("--resume state writes the picture anew"));
    for (const char* name : {"full.rescued.exr", "good.png", "timing.json", "state"}) EXPECT_TRUE(exists(name)) << name;
    EXPECT_EQ(readLinearRgb(path("full.rescued.exr")).width(), 32);
    EXPECT_EQ(render("-o again.exr --resume state"), 0) << said();
    EXPECT_EQ(readLinearRgb(path("again.exr")).data(), readLinearRgb(path("full.rescued.exr")).data());
}

// The limit of the shell, which kills programs that do not know of it. Blocks are 512 or 1024 bytes.
TEST_F(LostPicture, AFileThatIsTooLargeIsSaid) {
    folder_.write("old.exr", "old");
    EXPECT_EQ(render("-o old.exr --resolution 256x256", "ulimit -f 16; "), 1);
    EXPECT_THAT(said(), HasSubstr("cannot write old.exr: File too large; nor can it be written"));
    EXPECT_EQ(readFile(path("old.exr")), "old");
}

TEST_F(LostPicture, OutputsDoNotReplaceEachOther) {
    fs::create_symlink("a.exr", path("link.exr"));
    for (const char* words :
         {"-o a.exr -o a.exr", "-o a.exr -o ./a.exr", "-o a.exr -o link.exr", "-o a.exr --timing a.exr",
          "-o a.exr --checkpoint scene/../a.exr", "-o a.exr --timing t --checkpoint t"})
        EXPECT_THAT(refusal(words), HasSubstr("this is the same file as")) << words;
    EXPECT_FALSE(exists("a.exr"));
}

TEST_F(LostPicture, NothingThatIsReadIsReplaced) {
    const std::string room = readFile(path("scene/room.pbrt")), sky = readFile(path("sky.exr"));
    fs::create_hard_link(path("sky.exr"), path("hard.exr"));
    EXPECT_THAT(refusal("-o a.exr --timing scene/room.pbrt"), HasSubstr("the same file as the scene scene/room.pbrt"));
    EXPECT_THAT(refusal("-o a.exr --checkpoint scene/room.pbrt"), HasSubstr("which is read"));
    EXPECT_THAT(refusal("-o sky.exr"), HasSubstr("-o sky.exr: this is the same file as the scene's file"));
    EXPECT_THAT(refusal("-o hard.exr"), HasSubstr("the same file as the scene's file"));
    EXPECT_THAT(refusal("-D film.filename=sky.exr"), HasSubstr("the same file as the scene's file"));
    EXPECT_EQ(readFile(path("scene/room.pbrt")), room);
    EXPECT_EQ(readFile(path("sky.exr")), sky);
}

}  // namespace
}  // namespace drc
