#include "image/display.h"

#include <gtest/gtest.h>

#include "image/auto_exposure.h"
#include "image/test_images.h"

namespace drc {
namespace {

TEST(Display, ExposureIsOnTopOfTheAutomaticOne) {
    const Image image = testing_images::reference();
    EXPECT_EQ(exposureOf({}, image), 0);
    EXPECT_EQ(exposureOf({.exposure = -1.5f}, image), -1.5f);
    EXPECT_EQ(exposureOf({.autoExposure = true}, image), autoExposure(image));
    EXPECT_EQ(exposureOf({.exposure = 2, .autoExposure = true}, image), autoExposure(image) + 2);
}

TEST(Display, MetadataNamesExposureAndView) {
    EXPECT_EQ(displayMetadata(View::Agx, -1.25f),
              (std::map<std::string, std::string>{{"drc:display_exposure", "-1.25"}, {"drc:display_view", "agx"}}));
}

}  // namespace
}  // namespace drc
