#include "image/tga.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Bytes = std::vector<int>;

std::string toString(const Bytes& bytes) {
    std::string text;
    for (const int b : bytes) text += char(b);
    return text;
}

// A header of 2x2 pixels, and what follows it.
std::string tga(int kind, int bits, int descriptor, const Bytes& data, int paletteBits = 0, int paletteSize = 0,
                int paletteFirst = 0) {
    return toString({0, paletteBits > 0, kind, paletteFirst, 0, paletteSize, 0, paletteBits, 0, 0, 0, 0, 2, 0, 2, 0,
                     bits, descriptor}) +
           toString(data);
}

Bytes bytesOf(const std::string& file) {
    const ImageFile decoded = decodeTga({file, "a.tga"});
    EXPECT_EQ(decoded.encoding, Encoding::UInt8);
    Bytes bytes;
    for (const float v : decoded.image.data()) bytes.push_back(int(std::lround(v * 255)));
    return bytes;
}

std::string faultIn(const std::string& file) {
    return errorOf([&] { decodeTga({file, "a.tga"}); });
}

TEST(Tga, BeginsAtAnyCorner) {
    const Bytes grey = {1, 2, 3, 4};
    EXPECT_THAT(bytesOf(tga(3, 8, 0x00, grey)), ElementsAre(3, 4, 1, 2));  // from the bottom left
    EXPECT_THAT(bytesOf(tga(3, 8, 0x10, grey)), ElementsAre(4, 3, 2, 1));
    EXPECT_THAT(bytesOf(tga(3, 8, 0x20, grey)), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(bytesOf(tga(3, 8, 0x30, grey)), ElementsAre(2, 1, 4, 3));
}

TEST(Tga, ColoursAreBlueFirst) {
    EXPECT_THAT(bytesOf(tga(2, 24, 0x20, {3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10})),
                ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
    EXPECT_THAT(bytesOf(tga(2, 32, 0x28, {3, 2, 1, 90, 6, 5, 4, 91, 9, 8, 7, 92, 12, 11, 10, 93})),
                ElementsAre(1, 2, 3, 90, 4, 5, 6, 91, 7, 8, 9, 92, 10, 11, 12, 93));
    // 0rrrrrgggggbbbbb: 31 becomes 255, 16 becomes 132, 1 becomes 8.
    EXPECT_THAT(bytesOf(tga(2, 16, 0x21, {0x00, 0x7c, 0xe0, 0x83, 0x1f, 0x00, 0x01, 0x42})),
                ElementsAre(255, 0, 0, 0, 255, 0, 0, 0, 255, 132, 132, 8));
}

TEST(Tga, Palettes) {
    const Bytes data = {3, 2, 1, 6, 5, 4, /*indices*/ 7, 8, 8, 7};
    EXPECT_THAT(bytesOf(tga(1, 8, 0x20, data, 24, 2, 7)), ElementsAre(1, 2, 3, 4, 5, 6, 4, 5, 6, 1, 2, 3));
    EXPECT_THAT(faultIn(tga(1, 8, 0x20, {3, 2, 1, 6, 5, 4, 7, 9, 8, 7}, 24, 2, 7)),
                HasSubstr("a pixel has colour 9 of its palette, which has colours 7 to 8"));
    EXPECT_THAT(faultIn(tga(1, 8, 0x20, data)), HasSubstr("its colours are those of a palette, and it has none"));
}

TEST(Tga, RunsMayCrossRowsAndTheEnd) {
    EXPECT_THAT(bytesOf(tga(11, 8, 0x20, {0x82, 5, 0x00, 6})), ElementsAre(5, 5, 5, 6));
    EXPECT_THAT(bytesOf(tga(11, 8, 0x20, {0x00, 5, 0x85, 6})), ElementsAre(5, 6, 6, 6));
}

TEST(Tga, GreyWithAlpha) {
    const std::string file = tga(3, 16, 0x28, {1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_THAT(decodeTga({file, ""}).image.channelNames(), ElementsAre("Y", "A"));
    EXPECT_THAT(bytesOf(file), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_THAT(bytesOf(tga(3, 16, 0x20, {1, 2, 3, 4, 5, 6, 7, 8})), ElementsAre(1, 3, 5, 7));
}

TEST(Tga, SaysWhatIsWrong) {
    EXPECT_EQ(faultIn(tga(2, 24, 0, {1, 2, 3})), "cannot read a.tga: it is cut short after 21 bytes");
    EXPECT_THAT(faultIn(tga(10, 24, 0, {0x83, 1, 2})), HasSubstr("it is cut short"));
    EXPECT_THAT(faultIn("\1\2"), HasSubstr("it is cut short"));
    EXPECT_THAT(faultIn(tga(4, 24, 0, {})), HasSubstr("there is no TGA of kind 4"));
    EXPECT_THAT(faultIn(tga(0, 24, 0, {})), HasSubstr("there is no TGA of kind 0"));
    EXPECT_THAT(faultIn(tga(2, 7, 0, {})), HasSubstr("a TGA of kind 2 cannot have 7 bits per pixel"));
    EXPECT_THAT(faultIn(tga(1, 8, 0, {}, 12, 1)), HasSubstr("a TGA's palette cannot have 12 bits per colour"));
}

}  // namespace
}  // namespace drc
