#include "scene/crop_window.h"

#include <gmock/gmock.h>

#include <limits>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

CropWindow windowOf(const std::vector<double>& values) { return cropWindowOf(values); }
std::string complaintOf(const std::vector<double>& values) {
    return errorOf([&] { cropWindowOf(values); });
}

TEST(CropWindow, IsX0X1Y0Y1InEitherOrderOfEdges) {
    EXPECT_EQ(windowOf({0, 1, 0, 1}), (CropWindow{0, 1, 0, 1}));
    EXPECT_EQ(windowOf({0.25, 0.5, 0.1, 0.9}), (CropWindow{0.25f, 0.5f, 0.1f, 0.9f}));
    EXPECT_EQ(windowOf({1, 0, 0, 1}), (CropWindow{0, 1, 0, 1}));
    EXPECT_EQ(windowOf({0, 0.5, 0.75, 0.5}), (CropWindow{0, 0.5f, 0.5f, 0.75f}));
}

TEST(CropWindow, IsCutToTheFilm) {
    EXPECT_EQ(windowOf({-1, 0.5, 0.5, 7}), (CropWindow{0, 0.5f, 0.5f, 1}));
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(windowOf({-inf, inf, 0, 1}), (CropWindow{0, 1, 0, 1}));
}

TEST(CropWindow, NothingOfItOnTheFilmIsAnError) {
    EXPECT_EQ(complaintOf({0.5, 0.5, 0, 1}),
              "is empty from x0 = 0.5 to x1 = 0.5: it must be x0 x1 y0 y1 from 0 to 1, with x0 < x1 and y0 < y1");
    EXPECT_THAT(complaintOf({0, 1, 0.25, 0.25}), HasSubstr("is empty from y0 = 0.25 to y1 = 0.25"));
    EXPECT_THAT(complaintOf({1, 2, 0, 1}), HasSubstr("is empty from x0 = 1 to x1 = 2"));
    EXPECT_THAT(complaintOf({0, 1, -2, -1}), HasSubstr("is empty from y0"));
    EXPECT_THAT(complaintOf({1e-50, 2e-50, 0, 1}), HasSubstr("is empty"));  // the same to single precision
}

TEST(CropWindow, OtherThanFourNumbersIsAnError) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (size_t i = 0; i < 4; ++i) {
        std::vector<double> values{0, 1, 0, 1};
        values[i] = nan;
        EXPECT_EQ(complaintOf(values), "must be numbers, x0 x1 y0 y1 from 0 to 1");
    }
    EXPECT_EQ(complaintOf({0, 1, 0}), "must be four numbers, x0 x1 y0 y1, not 3");
    EXPECT_EQ(complaintOf({}), "must be four numbers, x0 x1 y0 y1, not 0");
}

}  // namespace
}  // namespace drc
