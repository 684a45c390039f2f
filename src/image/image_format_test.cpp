#include "image/image_format.h"

#include <gtest/gtest.h>

#include <string>

namespace drc {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

TEST(ImageFormat, IsToldByTheFirstBytes) {
    EXPECT_EQ(imageFormatOf("\x76\x2f\x31\x01\x02", "a.png"), ImageFormat::Exr);
    EXPECT_EQ(imageFormatOf("\x89PNG\r\n\x1a\n", "a.tga"), ImageFormat::Png);
    EXPECT_EQ(imageFormatOf("\xff\xd8\xff\xe0", "a"), ImageFormat::Jpeg);
    EXPECT_EQ(imageFormatOf("#?RGBE\n", "a.exr"), ImageFormat::RadianceHdr);
    EXPECT_EQ(imageFormatOf("PF\n1 1\n", "a.ppm"), ImageFormat::Pfm);
    for (const std::string_view tiff : {"II*\0...."sv, "MM\0*...."sv, "II+\0...."sv, "MM\0+...."sv})
        EXPECT_EQ(imageFormatOf(tiff, "a.tga"), ImageFormat::Tiff);
    EXPECT_EQ(imageFormatOf("P6\n1 1\n", "a.pfm"), ImageFormat::Unknown);
    EXPECT_EQ(imageFormatOf("", "a.exr"), ImageFormat::Unknown);
}

TEST(ImageFormat, TgaIsToldByItsNameOrItsEnd) {
    const std::string header = "\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x18\0"s;
    EXPECT_EQ(imageFormatOf(header, "folder.tga/a.TGA"), ImageFormat::Tga);
    EXPECT_EQ(imageFormatOf(header, "folder.tga/a.dat"), ImageFormat::Unknown);
    EXPECT_EQ(imageFormatOf(header + "bgr" + std::string(8, '\0') + "TRUEVISION-XFILE.\0"s, "a.dat"), ImageFormat::Tga);
    EXPECT_EQ(imageFormatOf("GIF89a, renamed in the wrong way", "a.tga"), ImageFormat::Unknown);
    EXPECT_EQ(imageFormatOf("neither this nor that", "a.tga"), ImageFormat::Tga);  // which then says what is wrong
}

TEST(ImageFormat, KnowsOthersByName) {
    EXPECT_EQ(foreignFormatOf("RIFF\1\2\3\4WEBPVP8 "sv), "WebP");
    EXPECT_EQ(foreignFormatOf("BM...."), "BMP");
    EXPECT_EQ(foreignFormatOf("XPDS...."), "DPX");
    EXPECT_EQ(foreignFormatOf("\0\0\0\x1c"
                              "ftypavif"sv),
              "AVIF");
    EXPECT_EQ(foreignFormatOf("RIFF"), "");
    EXPECT_EQ(foreignFormatOf(""), "");
}

}  // namespace
}  // namespace drc
