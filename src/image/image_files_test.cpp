// Files of all kinds, by several programs: what is read of each is, to the last bit, what OpenImageIO 2.4 reads. The
// files are the fuzzers' seeds, too. TIFF files are compared with what OpenImageIO 3.2 reads, parts of an EXR with what
// it reads of each, side by side.
#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <ostream>

#include "base/atomic_file.h"
#include "image/image_io.h"

namespace drc {
namespace {

struct Picture {
    const char* file;
    int width, height;
    std::string channels;
    Encoding encoding;
    uint32_t sum;  // CRC-32 of the values, as floats
};

void PrintTo(const Picture& picture, std::ostream* out) { *out << picture.file; }

const Picture kPictures[] = {
    {"tga/palette-24", 9, 7, "R,G,B", Encoding::UInt8, 0xc460d130},
    {"tga/palette-15-from-top", 9, 7, "R,G,B", Encoding::UInt8, 0x74027e72},
    {"tga/palette-16", 9, 7, "R,G,B", Encoding::UInt8, 0xdf7b315f},
    {"tga/palette-32-from-right", 9, 7, "R,G,B", Encoding::UInt8, 0x82d0637f},
    {"tga/palette-24-runs", 9, 7, "R,G,B", Encoding::UInt8, 0x732cdae6},
    {"tga/palette-24-wide-runs", 9, 7, "R,G,B", Encoding::UInt8, 0x83b3b0e7},
    {"tga/colour-15", 9, 7, "R,G,B", Encoding::UInt8, 0x2ab63813},
    {"tga/colour-16", 9, 7, "R,G,B", Encoding::UInt8, 0x7b8cb578},
    {"tga/colour-24", 9, 7, "R,G,B", Encoding::UInt8, 0xaa37f9b7},
    {"tga/colour-24-from-right", 9, 7, "R,G,B", Encoding::UInt8, 0x63921bbc},
    {"tga/colour-32", 9, 7, "R,G,B,A", Encoding::UInt8, 0x84effbdb},
    {"tga/colour-32-no-alpha-bits", 9, 7, "R,G,B,A", Encoding::UInt8, 0xb9dc9f23},
    {"tga/colour-15-runs", 9, 7, "R,G,B", Encoding::UInt8, 0x730d79ee},
    {"tga/colour-16-runs", 9, 7, "R,G,B", Encoding::UInt8, 0xd730030e},
    {"tga/colour-24-runs", 9, 7, "R,G,B", Encoding::UInt8, 0xf74c9e6c},
    {"tga/colour-32-runs", 9, 7, "R,G,B,A", Encoding::UInt8, 0x6a6a063a},
    {"tga/grey-8", 9, 7, "Y", Encoding::UInt8, 0x6595b787},
    {"tga/grey-16", 9, 7, "Y", Encoding::UInt8, 0x8e44d10a},
    {"tga/grey-8-runs", 9, 7, "Y", Encoding::UInt8, 0x0ec04426},
    {"tga/comment", 9, 7, "R,G,B", Encoding::UInt8, 0x5f245f80},
    {"tga/run-across-rows", 9, 7, "R,G,B", Encoding::UInt8, 0x86cf06d8},
    {"tga/run-beyond-the-end", 9, 7, "R,G,B", Encoding::UInt8, 0xe55eee65},
    {"tga/unused-palette", 9, 7, "R,G,B", Encoding::UInt8, 0x96f6f135},
    {"tga/version-2-alpha", 9, 7, "R,G,B,A", Encoding::UInt8, 0x8a70396c},
    {"tga/footer", 9, 7, "R,G,B", Encoding::UInt8, 0x23b665ce},
    {"hdr/plain", 19, 11, "R,G,B", Encoding::Float, 0x9cc98b9d},
    {"hdr/runs", 19, 11, "R,G,B", Encoding::Float, 0x9cc98b9d},
    {"hdr/narrow", 5, 11, "R,G,B", Encoding::Float, 0x68c26f42},
    {"hdr/wide", 700, 4, "R,G,B", Encoding::Float, 0x46ddb144},
    {"hdr/mantissas", 256, 1, "R,G,B", Encoding::Float, 0xb4729dc6},
    {"hdr/other-program", 19, 11, "R,G,B", Encoding::Float, 0x9cc98b9d},
    {"picture/png-grey-1-interlaced", 13, 11, "Y", Encoding::UInt8, 0x550323c9},
    {"picture/png-grey-2", 13, 11, "Y", Encoding::UInt8, 0x20ebb2d2},
    {"picture/png-grey-4-transparent", 13, 11, "Y,A", Encoding::UInt8, 0xc75c360b},
    {"picture/png-grey-8", 13, 11, "Y", Encoding::UInt8, 0xd62649ec},
    {"picture/png-grey-16-interlaced", 13, 11, "Y", Encoding::UInt16, 0x60bd2bb3},
    {"picture/png-grey-16-transparent", 13, 11, "Y,A", Encoding::UInt16, 0x2f093910},
    {"picture/png-colour-8-interlaced-transparent", 13, 11, "R,G,B,A", Encoding::UInt8, 0x840aa3e3},
    {"picture/png-colour-8", 13, 11, "R,G,B", Encoding::UInt8, 0xa571757d},
    {"picture/png-colour-16", 13, 11, "R,G,B", Encoding::UInt16, 0x0612124b},
    {"picture/png-colour-16-transparent", 13, 11, "R,G,B,A", Encoding::UInt16, 0x013d28fb},
    {"picture/png-palette-1-interlaced", 13, 11, "R,G,B", Encoding::UInt8, 0x84cd96e4},
    {"picture/png-palette-2-transparent", 13, 11, "R,G,B,A", Encoding::UInt8, 0x7f276e77},
    {"picture/png-palette-4", 13, 11, "R,G,B", Encoding::UInt8, 0x5e41a602},
    {"picture/png-palette-8-interlaced-transparent", 13, 11, "R,G,B,A", Encoding::UInt8, 0xeaccd107},
    {"picture/png-palette-8", 13, 11, "R,G,B", Encoding::UInt8, 0x27a53a1d},
    {"picture/png-palette-short", 5, 5, "R,G,B", Encoding::UInt8, 0x248b6fc9},
    {"picture/png-grey-alpha-8", 13, 11, "Y,A", Encoding::UInt8, 0x35083581},
    {"picture/png-grey-alpha-16-interlaced", 13, 11, "Y,A", Encoding::UInt16, 0x6aafd546},
    {"picture/png-colour-alpha-8", 13, 11, "R,G,B,A", Encoding::UInt8, 0x4e592202},
    {"picture/png-colour-alpha-16-interlaced", 13, 11, "R,G,B,A", Encoding::UInt16, 0x9868881b},
    {"picture/png-gamma", 5, 5, "R,G,B", Encoding::UInt8, 0x1a7b0842},
    {"picture/png-background", 5, 5, "R,G,B,A", Encoding::UInt8, 0x2550514e},
    {"picture/jpeg-grey", 37, 29, "Y", Encoding::UInt8, 0x875e9850},
    {"picture/jpeg-colour-420", 37, 29, "R,G,B", Encoding::UInt8, 0xf6c08226},
    {"picture/jpeg-colour-422-progressive", 37, 29, "R,G,B", Encoding::UInt8, 0x07ff5fd8},
    {"picture/jpeg-colour-444", 37, 29, "R,G,B", Encoding::UInt8, 0x9db89fbb},
    {"picture/jpeg-rgb", 37, 29, "R,G,B", Encoding::UInt8, 0x1c563cf6},
    {"picture/jpeg-arithmetic", 37, 29, "R,G,B", Encoding::UInt8, 0xe973da93},
    {"picture/jpeg-restarts", 37, 29, "R,G,B", Encoding::UInt8, 0xe973da93},
    {"picture/jpeg-cmyk", 37, 29, "R,G,B", Encoding::UInt8, 0x7a83ce98},
    {"picture/jpeg-cmyk-unmarked", 37, 29, "R,G,B", Encoding::UInt8, 0x730ada1c},
    {"picture/jpeg-ycck", 37, 29, "R,G,B", Encoding::UInt8, 0xac503b6c},
    {"picture/jpeg-turned", 37, 29, "R,G,B", Encoding::UInt8, 0x7d53d76a},
    {"picture/jpeg-without-end", 37, 29, "R,G,B", Encoding::UInt8, 0x7d53d76a},
    {"picture/tiff-alpha-float-tiles", 13, 11, "R,G,B,A", Encoding::Float, 0x9b675cbe},
    {"picture/tiff-big", 13, 11, "Y", Encoding::UInt8, 0xdbff34d7},
    {"picture/tiff-big-endian-16", 13, 11, "R,G,B", Encoding::UInt16, 0x486cbdfc},
    {"picture/tiff-black-and-white", 13, 11, "Y", Encoding::UInt8, 0x5d3f7571},
    {"picture/tiff-colour-16-tiles", 13, 11, "R,G,B", Encoding::UInt16, 0xfbacb3bf},
    {"picture/tiff-colour-8-lzw", 13, 11, "R,G,B", Encoding::UInt8, 0x905ec7d1},
    {"picture/tiff-colour-alpha-8", 13, 11, "R,G,B,A", Encoding::UInt8, 0x9d3fa9e0},
    {"picture/tiff-double", 13, 11, "Y", Encoding::Float, 0x5e257076},
    {"picture/tiff-float-planes", 13, 11, "R,G,B", Encoding::Float, 0x814445c6},
    {"picture/tiff-grey-8", 13, 11, "Y", Encoding::UInt8, 0x62100f9f},
    {"picture/tiff-half", 13, 11, "R,G,B", Encoding::Float, 0x9ebcbcca},
    {"picture/tiff-jpeg", 13, 11, "R,G,B", Encoding::UInt8, 0x139a4e85},
    {"picture/tiff-planes-of-four", 13, 11, "R,G,B,A", Encoding::UInt8, 0x8f43a8f6},
    {"picture/tiff-turned", 13, 11, "R,G,B", Encoding::UInt8, 0x7c8b3b3d},
    {"picture/exr-none", 9, 7, "R,G,B", Encoding::Float, 0x1475d324},
    {"picture/exr-rle", 9, 7, "R,G,B", Encoding::Float, 0xa04dd8cb},
    {"picture/exr-zips", 9, 7, "R,G,B", Encoding::Float, 0xe9ccbfa6},
    {"picture/exr-zip", 9, 7, "R,G,B", Encoding::Float, 0x9d72a481},
    {"picture/exr-piz", 9, 7, "R,G,B", Encoding::Float, 0x05601f99},
    {"picture/exr-pxr24", 9, 7, "R,G,B", Encoding::Float, 0x7a1ba30d},
    {"picture/exr-b44", 9, 7, "R,G,B", Encoding::Float, 0xed544750},
    {"picture/exr-b44a", 9, 7, "R,G,B", Encoding::Float, 0x0dbedeb2},
    {"picture/exr-dwaa", 9, 7, "R,G,B", Encoding::Float, 0x995297de},
    {"picture/exr-dwab", 9, 7, "R,G,B", Encoding::Float, 0x57bb83ab},
    {"picture/exr-layers", 9, 7, "R,G,B,A,Zback,u,N.X,N.Y,N.Z,a.b.R,a.b.G,a.b.B,albedo.R,albedo.G,albedo.B,depth.Z",
     Encoding::Float, 0xee250795},
    {"picture/exr-names", 9, 7, "Red,Green,Blue,Alpha", Encoding::Float, 0xbba8b7c7},
    {"picture/exr-case", 9, 7, "R,r,G,g,B", Encoding::Float, 0x3412d7ac},
    {"picture/exr-position-alpha", 9, 7, "X,Y,Z,A", Encoding::Float, 0x03e0a603},
    {"picture/exr-position-colour", 9, 7, "R,G,B,X,Y", Encoding::Float, 0x8faa71dc},
    {"picture/exr-position-or-not", 9, 7, "X,Z,Depth,T,W", Encoding::Float, 0x9dccc001},
    {"picture/exr-brightness-alpha", 9, 7, "Y,A", Encoding::Float, 0x98a07dcb},
    {"picture/exr-many-kinds", 9, 7, "R,G,B,Y,real,imag,AR,AG,AB,Z,Depth,Foo,bar,foo", Encoding::Float, 0x7cd8bbd2},
    {"picture/exr-two-layers", 9, 7, "Beauty.R,Beauty.G,Beauty.B,diffuse.R,diffuse.G,diffuse.B", Encoding::Float,
     0xdbaf58db},
    {"picture/exr-normals", 9, 7, "N.x,N.y,N.z,N.A,P.B,P.X,P.Z,P.Alpha", Encoding::Float, 0x0b297dc3},
    {"picture/exr-window-outside", 11, 4, "R,G,B", Encoding::Float, 0x0285d72d},
    {"picture/exr-window-within", 16, 9, "R,G,B", Encoding::Float, 0x5abb8a4c},
    {"picture/exr-decreasing", 9, 7, "R,G,B", Encoding::Float, 0xc7386a12},
    {"picture/exr-tiles", 9, 7, "R,G,B,A", Encoding::Float, 0xb7ecb09a},
    {"picture/exr-mip-levels", 9, 7, "R,G,B,A", Encoding::Float, 0xe9063f65},
    {"picture/exr-rip-levels", 9, 7, "R,G,B,A", Encoding::Float, 0xdd70d333},
    {"picture/exr-two-parts", 10, 7, "R,G,B,two.R,two.G,two.B", Encoding::Float, 0x82cd6321},
    {"picture/exr-two-parts-tiles", 10, 7, "R,G,B,two.R,two.G,two.B", Encoding::Float, 0x1a5f5f5b},
    {"picture/exr-depth", 9, 7, "Z", Encoding::Float, 0xb0da1c31},
};

class ImageFiles : public testing::TestWithParam<Picture> {};

TEST_P(ImageFiles, AreReadToTheLastBit) {
    const Picture& expected = GetParam();
    const std::string path = std::string(DRC_SOURCE_DIR) + "/tests/fuzz/corpus/" + expected.file;
    const std::string bytes = readFile(path);
    // TGA files are told by their names.
    const ImageFile file = decodeImage({bytes, path.find("/tga/") == std::string::npos ? path : path + ".tga"});
    EXPECT_EQ(file.image.width(), expected.width);
    EXPECT_EQ(file.image.height(), expected.height);
    EXPECT_EQ(file.encoding, expected.encoding);
    std::string channels;
    for (const std::string& name : file.image.channelNames()) channels += (channels.empty() ? "" : ",") + name;
    EXPECT_EQ(channels, expected.channels);
    const std::vector<float>& values = file.image.data();
    EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef*>(values.data()), uInt(values.size() * sizeof(float))),
              expected.sum);
}

std::string testName(const testing::TestParamInfo<Picture>& info) {
    std::string name = info.param.file;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == '-'; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Pictures, ImageFiles, testing::ValuesIn(kPictures), testName);

}  // namespace
}  // namespace drc
