#include "image/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include "base/folder_testing.h"
#include "image/color.h"

namespace drc {
namespace {

using namespace std::string_literals;
using testing::ElementsAre;
using testing::HasSubstr;

std::string bigEndian(uint32_t v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }

std::string chunk(const std::string& name, const std::string& data) {
    const std::string body = name + data;
    return bigEndian(uint32_t(data.size())) + body +
           bigEndian(uint32_t(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()))));
}

std::string deflated(const std::string& raw) {
    std::string packed(compressBound(raw.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size());
    packed.resize(size);
    return packed;
}

// One row, unfiltered: its bytes as stored.
std::string rowPng(int width, int bits, int colourType, const std::string& row, const std::string& chunks = "") {
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR",
                 bigEndian(uint32_t(width)) + bigEndian(1) + char(bits) + char(colourType) + std::string(3, '\0')) +
           chunks + chunk("IDAT", deflated('\0' + row)) + chunk("IEND", "");
}

std::vector<int> bytesOf(const std::string& file) {
    const ImageFile decoded = decodePng({file, "a.png"});
    std::vector<int> bytes;
    for (const float v : decoded.image.data()) bytes.push_back(int(std::lround(v * 255)));
    return bytes;
}

std::string faultIn(const std::string& file) {
    return errorOf([&] { decodePng({file, "a.png"}); });
}

TEST(Png, FewBitsBecomeEight) {
    EXPECT_THAT(bytesOf(rowPng(3, 1, PNG_COLOR_TYPE_GRAY, "\xa0")), ElementsAre(255, 0, 255));
    EXPECT_THAT(bytesOf(rowPng(4, 2, PNG_COLOR_TYPE_GRAY, "\x1b")), ElementsAre(0, 85, 170, 255));
    EXPECT_THAT(bytesOf(rowPng(2, 4, PNG_COLOR_TYPE_GRAY, "\x1f")), ElementsAre(17, 255));
}

TEST(Png, SixteenBitsAreKept) {
    const std::string file = rowPng(2, 16, PNG_COLOR_TYPE_GRAY, "\x12\x34\xff\xfe");
    const ImageFile decoded = decodePng({file, ""});
    EXPECT_EQ(decoded.encoding, Encoding::UInt16);
    EXPECT_FLOAT_EQ(decoded.image.data()[0], 0x1234 / 65535.f);
    EXPECT_FLOAT_EQ(decoded.image.data()[1], 65534 / 65535.f);
}

TEST(Png, PalettesAndTransparentColours) {
    const std::string palette = chunk("PLTE", "\1\2\3\4\5\6"), alpha = chunk("tRNS", "\x80");
    EXPECT_THAT(bytesOf(rowPng(2, 8, PNG_COLOR_TYPE_PALETTE, std::string("\1\0", 2), palette)),
                ElementsAre(4, 5, 6, 1, 2, 3));
    EXPECT_THAT(bytesOf(rowPng(2, 1, PNG_COLOR_TYPE_PALETTE, "\x40", palette + alpha)),
                ElementsAre(1, 2, 3, 128, 4, 5, 6, 255));
    EXPECT_THAT(bytesOf(rowPng(2, 8, PNG_COLOR_TYPE_GRAY, "\7\x8", chunk("tRNS", std::string("\0\7", 2)))),
                ElementsAre(7, 0, 8, 255));
}

TEST(Png, AlphaIsNotMultipliedIn) {
    const std::string file = rowPng(1, 8, PNG_COLOR_TYPE_RGB_ALPHA, "\xc8\x64\x32\x40");
    EXPECT_THAT(decodePng({file, ""}).image.channelNames(), ElementsAre("R", "G", "B", "A"));
    EXPECT_THAT(bytesOf(file), ElementsAre(200, 100, 50, 64));
    const std::string grey = rowPng(1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, "\xc8\x40");
    EXPECT_THAT(decodePng({grey, ""}).image.channelNames(), ElementsAre("Y", "A"));
    EXPECT_THAT(bytesOf(grey), ElementsAre(200, 64));
}

TEST(Png, GammaAndDamagedNotesChangeNothing) {
    const std::string row = "\x80";
    const std::string badText = "\0\0\0\3tEXtabc\1\2\3\4"s;
    EXPECT_THAT(bytesOf(rowPng(1, 8, PNG_COLOR_TYPE_GRAY, row, chunk("gAMA", bigEndian(100000)) + badText)),
                ElementsAre(128));
}

TEST(Png, WhatIsWrittenIsSrgbAndSaysSo) {
    Image image(2, 1);
    image.setRgb(0, 0, Rgb(0, .18f, 1));
    image.setRgb(1, 0, Rgb(-1, 5, .5f));
    const std::string file = encodePng(image);
    EXPECT_THAT(file, HasSubstr("sRGB"));
    EXPECT_THAT(bytesOf(file), ElementsAre(0, 118, 255, 0, 255, 188));
    EXPECT_THAT(errorOf([] { encodePng(Image()); }), HasSubstr("the image is empty"));
}

TEST(Png, SixteenBitsAreWritten) {
    Image image(3, 1);
    image.data() = {0, .18f, 1, -1, 7, 1e-5f, .5f, .25f, std::numeric_limits<float>::quiet_NaN()};
    const std::string bytes = encodePng(image, "a.png", {}, nullptr, PngBits::Sixteen);
    const ImageFile file = decodePng({bytes, "a.png"});
    EXPECT_EQ(file.encoding, Encoding::UInt16);
    for (size_t i = 0; i + 1 < image.data().size(); ++i)
        EXPECT_NEAR(file.image.data()[i], srgbEncode(clamp01(image.data()[i])), .51 / 65535) << i;
    EXPECT_EQ(file.image.data().back(), 0);
}

// What a file says of its gamma, before its pixels and without a word on sRGB, is told.
TEST(Png, TellsOfAnotherGamma) {
    const auto gammaOf = [](const std::string& chunks) {
        const std::string file = rowPng(1, 8, PNG_COLOR_TYPE_GRAY, "\x80", chunks);
        return decodePng({file, "a.png"}).gamma;
    };
    const std::string linear = chunk("gAMA", bigEndian(100000));
    EXPECT_EQ(gammaOf(""), 0);
    EXPECT_EQ(gammaOf(linear), 1);
    EXPECT_FLOAT_EQ(gammaOf(chunk("gAMA", bigEndian(55556))), .55556f);
    EXPECT_EQ(gammaOf(linear + chunk("sRGB", "\1")), 0);
    EXPECT_EQ(gammaOf(chunk("gAMA", bigEndian(45455))), 0);
    EXPECT_EQ(gammaOf(chunk("gAMA", bigEndian(0))), 0);
    EXPECT_EQ(gammaOf(chunk("gAMA", "\1")), 0);
}

TEST(Png, KeepsNotes) {
    const PngTexts texts{{"drc:view", "agx"}, {"Author", "J\u00f6rg"}, {"empty", ""}};
    const std::string file = encodePng(Image(2, 1), "a.png", texts);
    EXPECT_EQ(decodePngTexts({file, "a.png"}), texts);
    EXPECT_THAT(bytesOf(file), ElementsAre(0, 0, 0, 0, 0, 0));
    EXPECT_EQ(encodePng(Image(2, 1), "a.png", {}), encodePng(Image(2, 1)));
    for (const std::string& keyword : {""s, std::string(80, 'a'), " a"s, "a\n"s})
        EXPECT_EQ(errorOf([&] {
                      encodePng(Image(1, 1), "a.png", {{keyword, "x"}});
                  }),
                  "cannot write a.png: a keyword of its notes is not one");
}

TEST(Png, DamagedNotesAreLeftOut) {
    const std::string file = encodePng(Image(2, 1), "a.png", {{"a", "text"}, {"b", "\u00f6"}});
    for (size_t n = 0; n < file.size(); ++n) {
        const PngTexts texts = decodePngTexts({std::string_view(file).substr(0, n), "a.png"});
        EXPECT_TRUE(texts.empty() || texts.at("a") == "text") << n;
    }
    for (const std::string& data : {"no end"s, "\0x"s, "k\0\1\0\0\0packed"s, "k\0"s, "k\0\0\0en"s})
        EXPECT_TRUE(decodePngTexts({rowPng(1, 8, PNG_COLOR_TYPE_GRAY, "a", chunk("iTXt", data)), ""}).empty()) << data;
    std::string hostile = rowPng(1, 8, PNG_COLOR_TYPE_GRAY, "a", chunk("tEXt", "k\0v"s));
    EXPECT_EQ(decodePngTexts({hostile, ""}), (PngTexts{{"k", "v"}}));
    hostile[8 + 25] = '\x7f';  // a chunk of two gigabytes
    EXPECT_TRUE(decodePngTexts({hostile, ""}).empty());
    EXPECT_EQ(decodePngTexts({rowPng(1, 8, PNG_COLOR_TYPE_GRAY, "a", chunk("tEXt", "k\0\xf6"s)), ""}).at("k"), "?");
}

TEST(Png, SaysWhatIsWrong) {
    const std::string whole = rowPng(3, 8, PNG_COLOR_TYPE_GRAY, "abc");
    for (size_t n = 8; n < whole.size(); ++n)
        EXPECT_EQ(faultIn(whole.substr(0, n)), "cannot read a.png: it is cut short") << n;
    std::string damaged = whole;
    damaged[8 + 25 + 12] ^= 1;  // within IDAT
    EXPECT_THAT(faultIn(damaged), HasSubstr("cannot read a.png: IDAT: "));
    EXPECT_THAT(faultIn(rowPng(3, 8, PNG_COLOR_TYPE_GRAY, "ab")), HasSubstr("Not enough image data"));
    EXPECT_THAT(faultIn(rowPng(1, 8, PNG_COLOR_TYPE_PALETTE, "a")), HasSubstr("Missing PLTE"));
    EXPECT_THAT(faultIn(rowPng(100000, 8, PNG_COLOR_TYPE_GRAY, "a")), HasSubstr("cannot read a.png: "));
}

}  // namespace
}  // namespace drc
