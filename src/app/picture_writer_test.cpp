#include "app/picture_writer.h"

#include <gmock/gmock.h>

#include <filesystem>

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

TEST_F(PictureWriterTest, PathsAreCheckedBeforeTheWork) {
    EXPECT_EQ(outputKind("x/y.EXR"), OutputKind::Exr);
    EXPECT_EQ(outputKind("y.png"), OutputKind::Png);
    EXPECT_THAT(errorOf([] { outputKind("y.jpg"); }),
                testing::HasSubstr("-o y.jpg: pictures are written as .exr or .png"));
    EXPECT_THAT(errorOf([&] { checkOutput("-o", path("none/y.png")); }), testing::HasSubstr("there is no folder"));
    EXPECT_EQ(errorOf([&] { checkOutput("-o", path("y.png")); }), "");
}

}  // namespace
}  // namespace drc
