#include "image/side_by_side.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

// Green tells the picture, red and blue the pixel.
std::vector<Image> pictures(int count, int width = 12, int height = 8) {
    std::vector<Image> images;
    for (int i = 0; i < count; ++i) {
        images.emplace_back(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) images.back().setRgb(x, y, Rgb(float(x), 10 + float(i), float(y)));
    }
    return images;
}

TEST(Strips, EachShowsItsOwnPart) {
    const Image columns = strips(pictures(3), false, 2);
    ASSERT_EQ(sizeString(columns), "12x8");
    // Lines on 3, 4 and on 7, 8.
    for (int x = 0; x < 12; ++x) {
        const bool isLine = x == 3 || x == 4 || x == 7 || x == 8;
        EXPECT_EQ(columns.rgb(x, 5), isLine ? Rgb(1.f) : Rgb(float(x), 10 + float(x / 4), 5)) << x;
    }
    const Image rows = strips(pictures(2), true, 0);
    EXPECT_EQ(rows.rgb(7, 3), Rgb(7, 10, 3));
    EXPECT_EQ(rows.rgb(7, 4), Rgb(7, 11, 4));
    EXPECT_EQ(strips(pictures(1)).data(), pictures(1)[0].data());
}

TEST(CutOuts, StandInRowsAndColumns) {
    const Image sheet = cutOuts(pictures(2), {{1, 2, 4, 4}, {9, 6, 12, 8}}, 2, 1);
    ASSERT_EQ(sizeString(sheet), "13x9");
    EXPECT_EQ(sheet.rgb(0, 0), Rgb(1, 10, 2));
    EXPECT_EQ(sheet.rgb(5, 3), Rgb(3, 10, 3));
    EXPECT_EQ(sheet.rgb(6, 0), Rgb(1.f));
    EXPECT_EQ(sheet.rgb(7, 0), Rgb(1, 11, 2));
    EXPECT_EQ(sheet.rgb(0, 4), Rgb(1.f));
    EXPECT_EQ(sheet.rgb(12, 8), Rgb(11, 11, 7));
}

TEST(SideBySide, SaysWhatDoesNotFit) {
    std::vector<Image> odd = pictures(2);
    odd.push_back(Image(12, 9));
    EXPECT_THAT(errorOf([&] { strips(odd); }), testing::AllOf(HasSubstr("12x8"), HasSubstr("12x9")));
    EXPECT_THAT(errorOf([&] { strips(pictures(13)); }), HasSubstr("13 strips do not fit on 12 pixels"));
    EXPECT_THAT(errorOf([&] { strips({}); }), HasSubstr("no pictures"));
    for (const PixelRect& part : {PixelRect{0, 0, 13, 8}, {-1, 0, 3, 3}, {4, 4, 4, 8}, {0, 5, 3, 2}})
        EXPECT_THAT(errorOf([&] { cutOuts(pictures(2), {part}); }), HasSubstr("cannot cut x"));
    EXPECT_THAT(errorOf([&] {
                    cutOuts(pictures(2), {{0, 0, 2, 2}, {0, 0, 3, 2}});
                }),
                HasSubstr("the parts differ in size: the first is 2x2, another is 3x2"));
    EXPECT_THAT(errorOf([&] { cutOuts(pictures(2), {{0, 0, 12, 8}}, 100000); }), HasSubstr("at most 65536 a side"));
}

}  // namespace
}  // namespace drc
