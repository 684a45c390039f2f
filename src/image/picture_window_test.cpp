#include "image/picture_window.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Image counted(int width, int height) {
    Image image(width, height, {"Y"});
    for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = float(i + 1);
    return image;
}

TEST(PictureWindow, PlacesAPartInTheWhole) {
    const Image part = counted(2, 2);
    EXPECT_THAT(placedInWindow(part, {1, 1, 4, 3}, "a").data(), ElementsAre(0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0));
    EXPECT_THAT(placedInWindow(part, {-1, -1, 2, 2}, "a").data(), ElementsAre(4, 0, 0, 0));
    EXPECT_THAT(placedInWindow(part, {5, 0, 2, 1}, "a").data(), ElementsAre(0, 0));
    EXPECT_THAT(placedInWindow(part, {-9, 0, 2, 1}, "a").data(), ElementsAre(0, 0));
    EXPECT_THAT(placedInWindow(part, {}, "a").data(), ElementsAre(1, 2, 3, 4));
    // Overscan is cut off.
    EXPECT_THAT(placedInWindow(counted(3, 3), {-1, -1, 1, 1}, "a").data(), ElementsAre(5));
    EXPECT_THAT(errorOf([&] {
                    (void)placedInWindow(part, {0, 0, 65536, 65536}, "a.exr");
                }),
                HasSubstr("cannot read a.exr: its size is 65536x65536"));
}

TEST(PictureWindow, TellsParts) {
    const Image image = counted(2, 2);
    EXPECT_TRUE(isWhole(image, {}));
    EXPECT_TRUE(isWhole(image, {0, 0, 2, 2, 7, 8}));
    EXPECT_FALSE(isWhole(image, {0, 0, 3, 2}));
    EXPECT_TRUE(overlaps(image, {-1, -1, 3, 2}));
    EXPECT_FALSE(overlaps(image, {-2, 0, 3, 2}));
    EXPECT_FALSE(overlaps(image, {3, 0, 3, 2}));
    EXPECT_EQ(placeString(image, {1, 2, 30, 20}), "2x2 at (1, 2) of 30x20");
}

TEST(PictureWindow, DifferentPlacesAreRefused) {
    const Image image = counted(2, 2), other = counted(3, 2);
    const auto fault = [&](const Image& of, const ExrWindow& first, const ExrWindow& second) {
        return errorOf([&] { requireSamePlace({"a.exr", image, first}, {"b.exr", of, second}, "compared"); });
    };
    EXPECT_EQ(fault(image, {1, 1, 8, 8}, {1, 1, 8, 8}), "");
    EXPECT_EQ(fault(image, {1, 1, 8, 8}, {1, 1, 8, 8, 5, 5}), "");
    EXPECT_EQ(fault(image, {1, 1, 8, 8}, {}), "");
    EXPECT_EQ(fault(image, {1, 1, 8, 8}, {1, 2, 8, 8}),
              "b.exr is 2x2 at (1, 2) of 8x8, but a.exr is 2x2 at (1, 1) of 8x8: only pictures of the same part of one "
              "whole can be compared");
    EXPECT_THAT(fault(image, {0, 0, 2, 2}, {0, 0, 4, 4}),
                HasSubstr("b.exr is 2x2 at (0, 0) of 4x4, but a.exr is 2x2:"));
    EXPECT_EQ(fault(other, {}, {}), "b.exr is 3x2, but a.exr is 2x2: only pictures of one size can be compared");
}

}  // namespace
}  // namespace drc
