#include "image/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
// After <cstdio>, which it needs.
#include <jpeglib.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kWidth = 24, kHeight = 16;

struct Options {
    J_COLOR_SPACE input = JCS_RGB, stored = JCS_YCbCr;
    int components = 3;
    bool isProgressive = false;
    bool isArithmetic = false;
};

// Component c is 40 (c + 1), and where `slope`, brighter to the right.
std::string jpeg(const Options& options, int slope = 0) {
    jpeg_compress_struct jpeg = {};
    jpeg_error_mgr errors;
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = kWidth;
    jpeg.image_height = kHeight;
    jpeg.input_components = options.components;
    jpeg.in_color_space = options.input;
    jpeg_set_defaults(&jpeg);
    jpeg_set_colorspace(&jpeg, options.stored);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg.arith_code = options.isArithmetic;
    if (options.isProgressive) jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<uint8_t> row;
    for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < options.components; ++c) row.push_back(uint8_t(40 * (c + 1) + slope * x));
    for (int y = 0; y < kHeight; ++y) {
        JSAMPROW at = row.data();
        jpeg_write_scanlines(&jpeg, &at, 1);
    }
    jpeg_finish_compress(&jpeg);
    std::string file(reinterpret_cast<char*>(bytes), size);
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
    return file;
}

std::vector<int> pixel(const std::string& file, int x) {
    const ImageFile decoded = decodeJpeg({file, "a.jpg"});
    EXPECT_EQ(decoded.image.width(), kWidth);
    EXPECT_EQ(decoded.image.height(), kHeight);
    EXPECT_EQ(decoded.encoding, Encoding::UInt8);
    std::vector<int> bytes;
    for (int c = 0; c < decoded.image.channels(); ++c)
        bytes.push_back(int(std::lround(decoded.image.at(x, 5, c) * 255)));
    return bytes;
}

std::string faultIn(const std::string& file) {
    return errorOf([&] { decodeJpeg({file, "a.jpg"}); });
}

TEST(Jpeg, GreyAndColours) {
    EXPECT_THAT(pixel(jpeg({JCS_GRAYSCALE, JCS_GRAYSCALE, 1}), 7), ElementsAre(40));
    EXPECT_THAT(pixel(jpeg({JCS_RGB, JCS_RGB}), 7), ElementsAre(40, 80, 120));
    for (const bool isProgressive : {false, true})
        for (const bool isArithmetic : {false, true})
            EXPECT_THAT(pixel(jpeg({.isProgressive = isProgressive, .isArithmetic = isArithmetic}, 4), 10),
                        ElementsAre(testing::AllOf(testing::Ge(79), testing::Le(81)),
                                    testing::AllOf(testing::Ge(119), testing::Le(121)),
                                    testing::AllOf(testing::Ge(159), testing::Le(161))));
}

// 40 / 255 of the light comes through the first ink, and 160 / 255 of that through black.
TEST(Jpeg, InksBecomeColours) {
    EXPECT_THAT(pixel(jpeg({JCS_CMYK, JCS_CMYK, 4}), 7), ElementsAre(25, 50, 75));
    EXPECT_THAT(pixel(jpeg({JCS_CMYK, JCS_YCCK, 4}), 7), ElementsAre(26, 50, 76));  // rounded twice
}

TEST(Jpeg, OnlyTheMarkOfTheEndMayBeMissing) {
    const std::string file = jpeg({}, 4);
    EXPECT_EQ(pixel(file.substr(0, file.size() - 2), 7), pixel(file, 7));
    EXPECT_EQ(faultIn(file.substr(0, file.size() - 12)), "cannot read a.jpg: it is cut short");
    EXPECT_EQ(faultIn(file.substr(0, 30)), "cannot read a.jpg: it is cut short");
    // Of several scans the last may be missing without any code being cut.
    for (const Options& options : {Options{.isProgressive = true}, Options{.isArithmetic = true}}) {
        const std::string several = jpeg(options, 4);
        EXPECT_EQ(faultIn(several.substr(0, several.size() - 2)), "cannot read a.jpg: it is cut short");
    }
}

TEST(Jpeg, SaysWhatIsWrong) {
    EXPECT_THAT(faultIn(jpeg({JCS_UNKNOWN, JCS_UNKNOWN, 2})), HasSubstr("it has 2 components"));
    std::string damaged = jpeg({});
    damaged[damaged.find("\xff\xc0") + 4] = 12;  // bits per value
    EXPECT_THAT(faultIn(damaged), HasSubstr("cannot read a.jpg: Unsupported JPEG data precision 12"));
}

// Scans of a few bytes, each of which goes through the whole picture.
TEST(Jpeg, ManyScansAreRefused) {
    std::string file = jpeg({.isProgressive = true});
    const size_t last = file.rfind("\xff\xda"), end = file.size() - 2;
    const std::string scan = file.substr(last, end - last);
    for (int i = 0; i < limits::kJpegScans; ++i) file.insert(end, scan);
    EXPECT_EQ(faultIn(file), "cannot read a.jpg: it has more than 500 scans");
}

}  // namespace
}  // namespace drc
