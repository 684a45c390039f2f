#include "image/image_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <bit>
#include <cstdlib>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "image/color.h"

namespace drc {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

using ImageIoTest = FolderTest;

Image makeImage(int width, int height, float first) {
    Image image(width, height);
    for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = first + float(i) * 0.37f;
    return image;
}

std::string pfm(const std::string& header, const std::vector<float>& values, bool bigEndian) {
    std::string bytes = header;
    for (const float v : values) {
        const auto word = std::bit_cast<uint32_t>(v);
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * (bigEndian ? 3 - i : i));
    }
    return bytes;
}

TEST_F(ImageIoTest, AFullDiskGivesOneErrorAndKeepsTheOldFile) {
    const Image small = makeImage(2, 2, 0);
    Image large(200, 200);
    for (size_t i = 0; i < large.data().size(); ++i) large.data()[i] = std::sin(float(i * i));
    writeExr(path("a.exr"), small);
    std::string exr, png;
    {
        const FileSizeLimit fullDisk(8192);
        exr = errorOf([&] { writeExr(path("a.exr"), large); });
        png = errorOf([&] { writePng(path("a.png"), large); });
    }
    EXPECT_EQ(exr, "cannot write " + path("a.exr") + ": File too large");
    EXPECT_EQ(png, "cannot write " + path("a.png") + ": File too large");
    EXPECT_EQ(readImage(path("a.exr")).width(), 2);
    EXPECT_EQ(std::distance(fs::directory_iterator(dir_), fs::directory_iterator()), 1);
}

TEST_F(ImageIoTest, PngIsSrgbEncoded) {
    Image image(4, 1);
    image.setRgb(0, 0, Rgb(0, 0.18f, 1));
    image.setRgb(1, 0, Rgb(-1, 5, 0.5f));
    image.setRgb(2, 0, Rgb(0.001f, 0.0031308f, 0.04f));
    writePng(path("a.png"), image);
    const ImageFile stored = readImageFile(path("a.png"));
    EXPECT_TRUE(stored.isSrgbEncoded());
    std::vector<int> bytes;
    for (const float v : stored.image.data()) bytes.push_back(int(std::lround(v * 255)));
    // 255 * srgb(x), rounded: 0.18 -> 117.6, 0.5 -> 187.5, 0.001 -> 3.3, 0.0031308 -> 10.3, 0.04 -> 56.4
    EXPECT_THAT(bytes, testing::ElementsAre(0, 118, 255, 0, 255, 188, 3, 10, 56, 0, 0, 0));

    Encoding encoding = Encoding::Float;
    const Image read = readImage(path("a.png"), &encoding);
    EXPECT_EQ(encoding, Encoding::UInt8);
    EXPECT_FLOAT_EQ(read.at(0, 0, 1), 118 / 255.f);
    EXPECT_FLOAT_EQ(readLinearRgb(path("a.png")).at(0, 0, 1), srgbDecode(118 / 255.f));
}

TEST_F(ImageIoTest, PfmRowsAndByteOrder) {
    const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};  // bottom row first
    writeFileAtomically(path("little.pfm"), pfm("PF\n2 2\n-1.0\n", values, false));
    writeFileAtomically(path("big.pfm"), pfm("PF 2 2 2\n", values, true));
    writeFileAtomically(path("grey.pfm"), pfm("Pf\n2 1\n-1\n", {.25f, -4}, false));
    const Image little = readImage(path("little.pfm")), big = readImage(path("big.pfm"));
    EXPECT_EQ(little.rgb(0, 0), Rgb(7, 8, 9));
    EXPECT_EQ(little.rgb(1, 1), Rgb(4, 5, 6));
    EXPECT_EQ(big.rgb(0, 0), Rgb(14, 16, 18));  // scale 2
    EXPECT_EQ(readImage(path("grey.pfm")).rgb(1, 0), Rgb(-4, -4, -4));
    EXPECT_FALSE(readImageFile(path("little.pfm")).isSrgbEncoded());
}

TEST_F(ImageIoTest, DamagedFilesGiveAnError) {
    const Image image = makeImage(64, 64, 0);
    writeExr(path("a.exr"), image);
    writePng(path("a.png"), image);
    for (const char* name : {"a.exr", "a.png"}) {
        const std::string bytes = readFile(path(name));
        writeFileAtomically(path(name), bytes.substr(0, bytes.size() / 2));
        EXPECT_THAT(errorOf([&] { readImage(path(name)); }), StartsWith("cannot read " + path(name) + ": ")) << name;
    }
    writeFileAtomically(path("text.exr"), "hello");
    writeFileAtomically(path("short.pfm"), "PF\n100 100\n-1\nxxxx");
    writeFileAtomically(path("huge.pfm"), "PF\n99999999 99999999\n-1\nxxxx");
    writeFileAtomically(path("word.pfm"), "PF\nwide 2\n-1\nxxxx");
    for (const char* name : {"text.exr", "short.pfm", "huge.pfm", "word.pfm", "missing.exr", "missing.png", "."}) {
        EXPECT_THAT(errorOf([&] { readImage(path(name)); }), StartsWith("cannot read " + path(name) + ": ")) << name;
    }
    EXPECT_EQ(errorOf([&] { readImage(path("missing.exr")); }),
              "cannot read " + path("missing.exr") + ": No such file or directory");
    EXPECT_THAT(errorOf([&] { readExrMetadata(path("a.png")); }), StartsWith("cannot read " + path("a.png")));
}

// Headers that promise what no memory holds: errors before anything is allocated.
TEST_F(ImageIoTest, HugeClaimsAreErrors) {
    const auto bigEndian = [](uint32_t v) { return std::string{char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; };
    const auto chunk = [&](const std::string& data) {
        uint32_t sum = ~0u;  // CRC-32
        for (const char c : data) {
            sum ^= uint8_t(c);
            for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0u);
        }
        return bigEndian(uint32_t(data.size()) - 4) + data + bigEndian(~sum);
    };
    const auto png = [&](uint32_t side) {
        return "\x89PNG\r\n\x1a\n" +
               chunk("IHDR" + bigEndian(side) + bigEndian(side) + std::string("\x08\x02\0\0\0", 5)) + chunk("IDAT");
    };
    const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 1000000\n";
    std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\xff\xff\xff\xff\x18\0", 18);
    tga += std::string(100, '\0');
    const std::pair<const char*, std::string> files[] = {
        {"a.png", png(1000000)}, {"b.png", png(60000)},
        {"a.hdr", hdr},          {"a.ppm", "P6\n1000000 1000000\n255\n123"},
        {"a.tga", tga},          {"a.pfm", "PF\n65536 65536\n-1\n1234"}};
    for (const auto& [name, bytes] : files) {
        writeFileAtomically(path(name), bytes);
        EXPECT_THAT(errorOf([&, &file = name] { readImageFile(path(file)); }),
                    StartsWith("cannot read " + path(name) + ": "))
            << name;
    }
}

// A crop is a part of the texture, and overscan lies outside of it. Other layers are not its colours.
TEST_F(ImageIoTest, TexturesAreWhatTheDisplayWindowShows) {
    Image image(2, 2, {"R", "G", "B", "A", "N.X"});
    for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = float(i + 1);
    writeExr(path("a.exr"), {{"", &image}}, {}, {1, 0, 4, 2});
    const ImageFile crop = readTextureFile(path("a.exr"));
    EXPECT_EQ(sizeString(crop.image), "4x2");
    EXPECT_THAT(crop.image.channelNames(), testing::ElementsAre("R", "G", "B", "A"));
    EXPECT_EQ(crop.image.rgb(0, 0), Rgb(0.f));
    EXPECT_EQ(crop.image.rgb(1, 0), image.rgb(0, 0));
    writeExr(path("a.exr"), {{"", &image}}, {}, {-1, -1, 1, 1});
    EXPECT_THAT(readTextureFile(path("a.exr")).image.data(), testing::ElementsAre(16, 17, 18, 19));
    EXPECT_EQ(sizeString(readImage(path("a.exr"))), "2x2");
    // Nothing to see: better than black.
    writeExr(path("a.exr"), {{"", &image}}, {}, {7, 7, 4, 4});
    testing::internal::CaptureStderr();
    EXPECT_EQ(readTextureFile(path("a.exr")).image.rgb(0, 0), image.rgb(0, 0));
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("a.exr has 2x2 at (7, 7) of 4x4, nothing of which"));
    // Brightness beside other layers.
    const Image grey(1, 1, {"Y"}), normal(1, 1, {"X", "Y", "Z"});
    writeExr(path("a.exr"), {{"", &grey}, {"N", &normal}});
    EXPECT_THAT(readTextureFile(path("a.exr")).image.channelNames(), testing::ElementsAre("Y"));
}

TEST_F(ImageIoTest, TellsFormatsByTheirBytesNotTheirNames) {
    const Image image = makeImage(3, 2, 0);
    writeExr(path("exr.png"), image);
    writePng(path("png.exr"), image);
    writeFileAtomically(path("pfm.tga"), pfm("PF\n1 1\n-1\n", {1, 2, 3}, false));
    EXPECT_EQ(readImage(path("exr.png")).data(), image.data());
    EXPECT_EQ(readImageFile(path("png.exr")).encoding, Encoding::UInt8);
    EXPECT_EQ(readImage(path("pfm.tga")).rgb(0, 0), Rgb(1, 2, 3));
}

TEST_F(ImageIoTest, NamesTheFormatThatIsNotRead) {
    const std::string read = "EXR, PNG, JPEG, TIFF, TGA, Radiance HDR and PFM files are read";
    writeFileAtomically(path("a.png"), "GIF89a and so on");
    writeFileAtomically(path("b.png"), "a letter");
    writeFileAtomically(path("c.png"), "");
    EXPECT_EQ(errorOf([&] { readImage(path("a.png")); }),
              "cannot read " + path("a.png") + ": it is a GIF file; " + read);
    EXPECT_EQ(errorOf([&] { readImage(path("b.png")); }),
              "cannot read " + path("b.png") + ": its format is unknown; " + read);
    EXPECT_EQ(errorOf([&] { readImage(path("c.png")); }), "cannot read " + path("c.png") + ": the file is empty");
}

TEST_F(ImageIoTest, DevicesAndPipesAreNotOpened) {
    ASSERT_EQ(mkfifo(path("pipe.png").c_str(), 0600), 0);
    EXPECT_EQ(errorOf([&] { readImage(path("pipe.png")); }),
              "cannot read " + path("pipe.png") + ": Not a file but a device");
    EXPECT_EQ(errorOf([&] { readImage("/dev/zero"); }), "cannot read /dev/zero: Not a file but a device");
    EXPECT_THAT(errorOf([&] { readImage(dir_.string()); }), HasSubstr("Is a directory"));
    EXPECT_EQ(errorOf([&] { readExrMetadata("/dev/zero"); }), "cannot read /dev/zero: Not a file but a device");
}

}  // namespace
}  // namespace drc
