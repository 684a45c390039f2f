#include "view/tev_packets.h"

#include <gtest/gtest.h>

#include <array>

namespace drc::tev {
namespace {

// The bytes of hexadecimal digits and of texts in quotes: "04 'ab' 00".
std::string bytes(std::string_view text) {
    std::string result;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ' ') continue;
        if (text[i] == '\'') {
            const size_t end = text.find('\'', i + 1);
            result += text.substr(i + 1, end - i - 1);
            i = end;
        } else {
            result += char(std::stoi(std::string(text.substr(i, 2)), nullptr, 16));
            ++i;
        }
    }
    return result;
}

TEST(TevPackets, OfFiles) {
    EXPECT_EQ(openImage("/a.exr", "R,G", true), bytes("11000000 07 01 '/a.exr' 00 'R,G' 00"));
    EXPECT_EQ(openImage("b", "", false), bytes("09000000 07 00 'b' 00 00"));
    EXPECT_EQ(reloadImage("/a.exr", false), bytes("0d000000 01 00 '/a.exr' 00"));
    EXPECT_EQ(closeImage("room"), bytes("0a000000 02 'room' 00"));
}

TEST(TevPackets, CreateImage) {
    const std::array<std::string, 2> channels{"R", "depth.Z"};
    EXPECT_EQ(createImage("room", true, 640, 3, channels),
              bytes("21000000 04 01 'room' 00 80020000 03000000 02000000 'R' 00 'depth.Z' 00"));
}

// 1 is 3f800000, -2 is c0000000, 0.5 is 3f000000, and infinity is 7f800000.
TEST(TevPackets, UpdateImage) {
    const std::array<std::string, 2> channels{"R", "Z"};
    const std::array<float, 4> values{1, -2, 0.5f, std::numeric_limits<float>::infinity()};
    EXPECT_EQ(updateImage("a", false, {5, 256, 6, 258}, channels, values),
              bytes("50000000 06 00 'a' 00 02000000 'R' 00 'Z' 00 05000000 00010000 01000000 02000000"
                    "0000000000000000 0100000000000000 0200000000000000 0200000000000000"
                    "0000803f 000000c0 0000003f 0000807f"));
}

}  // namespace
}  // namespace drc::tev
