#include "image/picture_file.h"

#include <gmock/gmock.h>
#include <png.h>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/color.h"
#include "image/exr_writer.h"
#include "image/image_io.h"

namespace drc {
namespace {

using PictureFileTest = FolderTest;

// One grey pixel in a PNG with a gamma, in hundred thousandths.
std::string pngWithGamma(int gamma, uint8_t value) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp of, png_bytep from, size_t n) {
            static_cast<std::string*>(png_get_io_ptr(of))->append(reinterpret_cast<char*>(from), n);
        },
        nullptr);
    png_set_IHDR(png, info, 1, 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_gAMA_fixed(png, info, gamma);
    png_write_info(png, info);
    png_write_row(png, &value);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

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

TEST_F(PictureFileTest, TheGammaOfAPngHolds) {
    // 128 of 255 in one pixel of grey.
    const std::string png = pngWithGamma(100000, uint8_t(128));
    folder_.write("a.png", png);
    EXPECT_NEAR(readPictureFile(path("a.png")).image.at(0, 0, 0), 128 / 255.f, 1e-6);
    EXPECT_NEAR(readLinearRgb(path("a.png")).at(0, 0, 2), 128 / 255.f, 1e-6);
}

TEST_F(PictureFileTest, APartsNameStandsForTheBeauty) {
    PictureFile picture;
    picture.image = Image(1, 1, {"R", "G", "B", "Z", "depth.Z"});
    picture.beautyPart = "rgba";
    EXPECT_EQ(layerNamed(picture, "rgba"), "");
    EXPECT_EQ(layerNamed(picture, "rgba.Z"), "Z");
    EXPECT_EQ(layerNamed(picture, "rgba.N"), "rgba.N");
    EXPECT_EQ(layerNamed(picture, "depth"), "depth");
    EXPECT_EQ(layerNamed(picture, "none"), "none");
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
