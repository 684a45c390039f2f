#include "render/picture_writer.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "base/folder_testing.h"

namespace drc {
namespace {

class PictureWriterTest : public FolderTest {
  protected:
    void writeOld(const std::string& name, const ExrMetadata& metadata) const {
        writeExr(path(name), Image(2, 2), metadata);
    }
    std::vector<std::string> diverted(const std::vector<std::string>& outputs, int samples) const {
        PictureWriter writer(settings_, outputs, false);
        writer.divertFromBetterPictures(samples);
        return writer.outputs();
    }
    RenderSettings settings_;
};

TEST_F(PictureWriterTest, InterruptedRendersReplaceOnlyWhatIsWorse) {
    using Paths = std::vector<std::string>;
    // Nothing there.
    EXPECT_EQ(diverted({path("a.exr"), path("a.png")}, 3), (Paths{path("a.exr"), path("a.png")}));
    // More samples, and as many.
    writeOld("a.exr", {{"drc:spp", "4"}});
    EXPECT_EQ(diverted({path("a.exr")}, 3), Paths{path("a.interrupted.exr")});
    EXPECT_EQ(diverted({path("a.exr")}, 4), Paths{path("a.interrupted.exr")});
    EXPECT_EQ(diverted({path("a.exr")}, 5), Paths{path("a.exr")});
    // Somebody else's, or a kind that says nothing.
    writeOld("b.exr", {});
    EXPECT_EQ(diverted({path("b.exr")}, 3), Paths{path("b.interrupted.exr")});
    folder_.write("a.png", "PNG");
    EXPECT_EQ(diverted({path("a.png")}, 3), Paths{path("a.interrupted.png")});
    // The EXR speaks for the PNG that was written with it.
    EXPECT_EQ(diverted({path("a.exr"), path("a.png")}, 5), (Paths{path("a.exr"), path("a.png")}));
    folder_.write("c.exr", "no picture");
    EXPECT_EQ(diverted({path("c.exr")}, 3), Paths{path("c.interrupted.exr")});
}

// Those of earlier renders that were interrupted, and other outputs of this one.
TEST_F(PictureWriterTest, InterruptedPicturesReplaceOnlyWhatIsWorseToo) {
    using Paths = std::vector<std::string>;
    writeOld("a.exr", {{"drc:spp", "100"}});
    writeOld("a.interrupted.exr", {{"drc:spp", "50"}});
    EXPECT_EQ(diverted({path("a.exr")}, 60), Paths{path("a.interrupted.exr")});
    EXPECT_EQ(diverted({path("a.exr")}, 40), Paths{path("a.interrupted-2.exr")});
    EXPECT_EQ(diverted({path("a.exr"), path("a.interrupted-2.exr")}, 40),
              (Paths{path("a.interrupted-3.exr"), path("a.interrupted-2.exr")}));
    folder_.write("b.png", "");
    EXPECT_EQ(diverted({path("b.exr"), path("b.png")}, 3), (Paths{path("b.exr"), path("b.interrupted.png")}));
}

TEST_F(PictureWriterTest, WhatCannotBeWrittenIsWrittenElsewhereAndTheOthersInTheirPlace) {
    std::filesystem::create_symlink("/dev/full", path("a.exr"));
    folder_.write("scene/room.pbrt", "");
    PictureWriter writer(settings_, {path("a.exr"), path("folder/b.exr"), path("c.png")}, false, {},
                         path("scene/room.pbrt"));
    testing::internal::CaptureStderr();
    writer.write({"1", "2", "3"});
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_FALSE(writer.allInPlace());
    EXPECT_EQ(writer.outputs(), (std::vector{path("a.rescued.exr"), path("scene/b.rescued.exr"), path("c.png")}));
    EXPECT_EQ(readFile(path("a.rescued.exr")), "1");
    EXPECT_EQ(readFile(path("scene/b.rescued.exr")), "2");
    EXPECT_EQ(readFile(path("c.png")), "3");
    EXPECT_THAT(said, testing::HasSubstr("cannot write " + path("a.exr") +
                                         ": No space left on device; the picture is in " + path("a.rescued.exr")));
    EXPECT_THAT(said,
                testing::HasSubstr("No such file or directory; the picture is in " + path("scene/b.rescued.exr")));
}

TEST_F(PictureWriterTest, PathsAreCheckedBeforeTheWork) {
    EXPECT_EQ(outputKind("x/y.EXR"), OutputKind::Exr);
    EXPECT_EQ(outputKind("y.png"), OutputKind::Png);
    EXPECT_THAT(errorOf([] { outputKind("y.jpg"); }),
                testing::HasSubstr("-o y.jpg: pictures are written as .exr or .png"));
    EXPECT_THAT(errorOf([&] { checkOutput("-o", path("none/y.png")); }), testing::HasSubstr("there is no folder"));
    EXPECT_EQ(errorOf([&] { checkOutput("-o", path("y.png")); }), "");
    std::filesystem::create_directory(path("z.png"));
    EXPECT_EQ(errorOf([&] { checkOutput("-o", path("z.png")); }),
              "-o: cannot write " + path("z.png") + ": Is a directory");
    EXPECT_EQ(errorOf([&] { checkOutput("list:3:", path("z.png")); }),
              "list:3: cannot write " + path("z.png") + ": Is a directory");
}

}  // namespace
}  // namespace drc
