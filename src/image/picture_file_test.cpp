#include "image/picture_file.h"

#include <gmock/gmock.h>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/color.h"
#include "image/image_io.h"

namespace drc {
namespace {

using PictureFileTest = FolderTest;

TEST_F(PictureFileTest, HasAllThatAnExrHas) {
    Image beauty(3, 2), depth(3, 2, {"Z"});
    beauty.setRgb(1, 1, Rgb(1, 2, 3));
    writeExr(path("a.exr"), {{"", &beauty}, {"depth", &depth}}, {{"drc:seed", "4"}}, {5, 6, 40, 30});
    const PictureFile file = readPictureFile(path("a.exr"));
    EXPECT_THAT(file.image.channelNames(), testing::ElementsAre("R", "G", "B", "depth.Z"));
    EXPECT_EQ(file.image.at(1, 1, 2), 3);
    EXPECT_EQ(file.metadata.at("drc:seed"), "4");
    EXPECT_EQ(file.window.x, 5);
    EXPECT_EQ(file.window.y, 6);
    EXPECT_EQ(file.window.fullWidth, 40);
    EXPECT_EQ(file.window.fullHeight, 30);
    writeExr(path("b.exr"), {{"", &beauty}}, file.metadata, file.window);
    EXPECT_EQ(readPictureFile(path("b.exr")).window.fullHeight, 30);
}

TEST_F(PictureFileTest, IntegersBecomeLinear) {
    Image image(2, 1);
    image.setRgb(0, 0, Rgb(0.25f, 0.5f, 1));
    writeFileAtomically(path("a.png"), encodePng(image, "a.png", {{"k", "v"}}));
    const PictureFile file = readPictureFile(path("a.png"));
    EXPECT_NEAR(file.image.at(0, 0, 0), 0.25, 0.003);
    EXPECT_EQ(file.encoding, Encoding::UInt8);
    EXPECT_EQ(file.metadata.at("k"), "v");
    EXPECT_EQ(file.window.fullWidth, 0);
}

TEST_F(PictureFileTest, AlphaIsMultipliedIn) {
    // 200 of 255 with alpha 51 of 255: an uncompressed TGA of one pixel, B, G, R, A.
    std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x28", 18);
    tga += "\xc8\xc8\xc8\x33";
    folder_.write("a.tga", tga);
    const PictureFile file = readPictureFile(path("a.tga"));
    EXPECT_NEAR(file.image.at(0, 0, 0), srgbDecode(200 / 255.f) * 0.2f, 1e-6);
    EXPECT_NEAR(file.image.at(0, 0, file.image.channelIndex("A")), 0.2, 1e-6);
}

TEST(ClearNonFinite, CountsPixels) {
    Image image(2, 2);
    image.data() = {1, kInfinity, std::numeric_limits<float>::quiet_NaN(), 2, 3, 4, -kInfinity, 5, 6, 7, 8, 9};
    EXPECT_EQ(clearNonFinite(image), 2);
    EXPECT_THAT(image.data(), testing::ElementsAre(1, 0, 0, 2, 3, 4, 0, 5, 6, 7, 8, 9));
    EXPECT_EQ(clearNonFinite(image), 0);
}

}  // namespace
}  // namespace drc
