#include "base/frame_pattern.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(FramePattern, PutsNumbersInPlaceOfTheSigns) {
    EXPECT_EQ(FramePattern("-o", "f_####.exr").path(7), "f_0007.exr");
    EXPECT_EQ(FramePattern("-o", "f.#.exr").path(12345), "f.12345.exr");
    EXPECT_EQ(FramePattern("-o", "./a#b/##").path(0), "./a#b/00");
}

TEST(FramePattern, RefusesOtherNames) {
    for (const char* name : {"f.exr", "f_#_#.exr", "a##/f.exr", ""})
        EXPECT_THAT(errorOf([&] { FramePattern("-o", name); }), HasSubstr("run of #")) << name;
}

TEST(FrameNumbers, AreThoseOfTheList) {
    EXPECT_THAT(frameNumbers("--frames", "3"), ElementsAre(3));
    EXPECT_THAT(frameNumbers("--frames", "1,8-10,4"), ElementsAre(1, 4, 8, 9, 10));
    EXPECT_THAT(frameNumbers("--frames", "0007-0008"), ElementsAre(7, 8));
}

TEST(FrameNumbers, RefusesNonsense) {
    for (const char* list :
         {"", "a", "1-", "-3", "3-1", "1,,2", "1-2-3", "1,1", "1-4,2", "0-2000000000", "99999999999"})
        EXPECT_THAT(errorOf([&] { frameNumbers("--frames", list); }), HasSubstr(std::string("--frames ") + list))
            << list;
}

}  // namespace
}  // namespace drc
