#include "image/radiance_hdr.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kHead = "#?RADIANCE\n# by hand\nEXPOSURE=3\nFORMAT=32-bit_rle_rgbe\n\n";

std::string bytes(const std::vector<int>& values) {
    std::string text;
    for (const int v : values) text += char(v);
    return text;
}

Image decode(const std::string& file) {
    ImageFile decoded = decodeRadianceHdr({file, "a.hdr"});
    EXPECT_EQ(decoded.encoding, Encoding::Float);
    return decoded.image;
}

std::string faultIn(const std::string& file) {
    return errorOf([&] { decodeRadianceHdr({file, "a.hdr"}); });
}

// The red of a picture of 3x2 pixels, from the top.
std::vector<float> reds(const std::string& size) {
    std::vector<int> pixels;
    for (int i = 0; i < 6; ++i) pixels.insert(pixels.end(), {i + 2, 0, 0, 136});
    const Image image = decode(kHead + size + "\n" + bytes(pixels));
    EXPECT_EQ(image.width(), 3);
    EXPECT_EQ(image.height(), 2);
    std::vector<float> values;
    for (int i = 0; i < 6; ++i) values.push_back(image.at(i % 3, i / 3, 0));
    return values;
}

TEST(RadianceHdr, ValuesAreMantissasTimesAPowerOfTwo) {
    const Image image = decode(kHead + "-Y 1 +X 3\n" + bytes({200, 100, 0, 136, 128, 1, 255, 129, 9, 9, 9, 0}));
    EXPECT_EQ(image.rgb(0, 0), Rgb(200, 100, 0));
    EXPECT_EQ(image.rgb(1, 0), Rgb(1, 1 / 128.f, 255 / 128.f));
    EXPECT_EQ(image.rgb(2, 0), Rgb(0, 0, 0));
}

TEST(RadianceHdr, IsTurnedUpright) {
    EXPECT_THAT(reds("-Y 2 +X 3"), ElementsAre(2, 3, 4, 5, 6, 7));
    EXPECT_THAT(reds("-Y 2 -X 3"), ElementsAre(4, 3, 2, 7, 6, 5));
    EXPECT_THAT(reds("+Y 2 +X 3"), ElementsAre(5, 6, 7, 2, 3, 4));
    EXPECT_THAT(reds("+Y 2 -X 3"), ElementsAre(7, 6, 5, 4, 3, 2));
    EXPECT_THAT(reds("+X 3 -Y 2"), ElementsAre(2, 4, 6, 3, 5, 7));
    EXPECT_THAT(reds("-X 3 -Y 2"), ElementsAre(6, 4, 2, 7, 5, 3));
    EXPECT_THAT(reds("+X 3 +Y 2"), ElementsAre(3, 5, 7, 2, 4, 6));
    EXPECT_THAT(reds("-X 3 +Y 2"), ElementsAre(7, 5, 3, 6, 4, 2));
}

TEST(RadianceHdr, RunsOfEachChannel) {
    const std::string row = bytes({2, 2, 0, 8, 136, 5, 4, 1, 2, 3, 4, 132, 9, 8, 6, 6, 6, 6, 6, 6, 6, 6, 136, 136});
    const Image image = decode(kHead + "-Y 1 +X 8\n" + row);
    EXPECT_EQ(image.rgb(0, 0), Rgb(5, 1, 6));
    EXPECT_EQ(image.rgb(3, 0), Rgb(5, 4, 6));
    EXPECT_EQ(image.rgb(7, 0), Rgb(5, 9, 6));
}

TEST(RadianceHdr, RunsOfPixels) {
    // 3 times, then 1 * 256 times more.
    const Image image =
        decode(kHead + "-Y 1 +X 262\n" + bytes({7, 0, 0, 136, 1, 1, 1, 3, 1, 1, 1, 1, 8, 0, 0, 136, 1, 1, 1, 1}));
    EXPECT_EQ(image.at(259, 0, 0), 7);
    EXPECT_EQ(image.at(260, 0, 0), 8);
    EXPECT_EQ(image.at(261, 0, 0), 8);
}

TEST(RadianceHdr, SaysWhatIsWrong) {
    EXPECT_THAT(faultIn("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"),
                HasSubstr("its FORMAT is 32-bit_rle_xyze, and 32-bit_rle_rgbe is read"));
    EXPECT_THAT(faultIn(kHead + "1 1\n1234"), HasSubstr("its size is given as \"1 1\", not as \"-Y HEIGHT +X WIDTH\""));
    EXPECT_THAT(faultIn(kHead + "-Y 1 +Y 1\n1234"), HasSubstr("its size is given as"));
    EXPECT_THAT(faultIn(kHead + "-Y 0 +X 1\n1234"), HasSubstr("its size is 1x0"));
    EXPECT_THAT(faultIn(kHead + "-Y 3000000000 +X 1\n1234"), HasSubstr("its size is given as"));
    EXPECT_THAT(faultIn("#?RADIANCE\nFORMAT="), HasSubstr("it is cut short"));
    EXPECT_EQ(faultIn(kHead + "-Y 2 +X 1\n12345"), "cannot read a.hdr: it is cut short after 71 bytes");
    EXPECT_THAT(faultIn(kHead + "-Y 1 +X 8\n" + bytes({2, 2, 0, 9, 137, 5})),
                HasSubstr("a row of 8 pixels says that it has 9"));
    EXPECT_THAT(faultIn(kHead + "-Y 1 +X 8\n" + bytes({2, 2, 0, 8, 137, 5})),
                HasSubstr("a run of 9 pixels stands where 8 are left in the row"));
    EXPECT_THAT(faultIn(kHead + "-Y 1 +X 3\n" + bytes({1, 1, 1, 3})), HasSubstr("a run of 3 pixels"));
    EXPECT_THAT(faultIn(kHead + "-Y 1 +X 3\n" + bytes({9, 9, 9, 130, 1, 1, 1, 3})), HasSubstr("where 2 are left"));
}

}  // namespace
}  // namespace drc
