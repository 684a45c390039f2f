#include "image/exr_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

std::string littleEndian(uint32_t v) { return {char(v), char(v >> 8), char(v >> 16), char(v >> 24)}; }

std::string attribute(const std::string& type, const std::string& value, size_t size) {
    return "note\0"s + type + '\0' + littleEndian(uint32_t(size)) + value;
}
std::string attribute(const std::string& type, const std::string& value) {
    return attribute(type, value, value.size());
}

// A file that has one attribute and, if of several parts, a second header with another.
std::string fault(const std::string& note, bool isMultiPart = false) {
    std::string bytes = "\x76\x2f\x31\x01\x02"s + char(isMultiPart ? 0x10 : 0) + "\0\0"s;
    bytes += isMultiPart ? attribute("int", "1234") + '\0' + note + "\0\0"s : note + '\0';
    return errorOf([&] { requireSoundExrHeaders({bytes, "a.exr"}); });
}

TEST(ExrHeader, SoundAttributesPass) {
    const std::string channel = "R\0"s + std::string(16, '\1');
    for (const bool isMultiPart : {false, true}) {
        EXPECT_EQ(fault(attribute("string", "any length"), isMultiPart), "");
        EXPECT_EQ(fault(attribute("of another program", "abc"), isMultiPart), "");
        EXPECT_EQ(fault(attribute("v3f", std::string(12, 'a')), isMultiPart), "");
        EXPECT_EQ(fault(attribute("chlist", channel + channel + '\0'), isMultiPart), "");
        EXPECT_EQ(fault(attribute("stringvector", littleEndian(2) + "ab" + littleEndian(0)), isMultiPart), "");
        EXPECT_EQ(fault(attribute("preview", littleEndian(2) + littleEndian(1) + "rgbargba"), isMultiPart), "");
    }
}

TEST(ExrHeader, AttributesBeyondTheFileAreRefused) {
    for (const bool isMultiPart : {false, true}) {
        EXPECT_THAT(fault(attribute("string", "abc", 0x60000000), isMultiPart),
                    HasSubstr("cannot read a.exr: it is cut short after"));
        EXPECT_THAT(fault(attribute("of another program", "abc", 0xffffffff), isMultiPart),
                    HasSubstr("it is cut short"));
    }
}

TEST(ExrHeader, SizesThatNoValueOfTheTypeHasAreRefused) {
    EXPECT_EQ(fault(attribute("v3f", std::string(13, 'a'))),
              "cannot read a.exr: its attribute note has 13 bytes, which no v3f has");
    EXPECT_THAT(fault(attribute("chlist", "R\0"s + std::string(15, '\1'))), HasSubstr("which no chlist has"));
    EXPECT_THAT(fault(attribute("chlist", "\0beyond the last"s)), HasSubstr("which no chlist has"));
    EXPECT_THAT(fault(attribute("stringvector", littleEndian(0x60000000) + "ab")),
                HasSubstr("which no stringvector has"));
    EXPECT_THAT(fault(attribute("preview", littleEndian(1 << 31) + littleEndian(2) + "rgba")),
                HasSubstr("which no preview has"));
    EXPECT_THAT(fault(attribute("floatvector", "12345")), HasSubstr("which no floatvector has"));
}

}  // namespace
}  // namespace drc
