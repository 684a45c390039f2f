#include "pbrt/color_space.h"

#include <gtest/gtest.h>

#include "image/color.h"

namespace drc::pbrt {
namespace {

void expectNear(const Rgb& a, const Rgb& b, float tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(ColorSpace, SrgbIsOurOwn) {
    expectNear(ColorSpace::srgb().light(Rgb(0.2f, 0.5f, 0.7f)), Rgb(0.2f, 0.5f, 0.7f), 3e-4f);
    expectNear(ColorSpace::srgb().reflectance(Rgb(0.2f, 0.5f, 0.7f)), Rgb(0.2f, 0.5f, 0.7f), 3e-4f);
}

TEST(ColorSpace, WhiteReflectanceIsWhiteInEverySpace) {
    for (const std::string_view name : ColorSpace::names()) {
        const ColorSpace* space = ColorSpace::named(name);
        ASSERT_NE(space, nullptr) << name;
        expectNear(space->reflectance(Rgb(1.f)), Rgb(1.f), 3e-4f);
        EXPECT_NEAR(luminance(space->light(Rgb(1.f))), 1, 1e-3f) << name;
    }
    EXPECT_EQ(ColorSpace::named("rec709"), nullptr);
}

TEST(ColorSpace, PublishedMatrices) {
    // The inverse of the conversion in ITU-R BT.2087, from BT.2020 to BT.709.
    const Rgb c = ColorSpace::named("rec2020")->light(Rgb(0.5f, 0.4f, 0.3f));
    expectNear(c,
               Rgb(1.6605f * .5f - .5876f * .4f - .0728f * .3f, -.1246f * .5f + 1.1329f * .4f - .0083f * .3f,
                   -.0182f * .5f - .1006f * .4f + 1.1187f * .3f),
               1e-3f);
    // Pure green of a wider space has negative red, which is clamped.
    EXPECT_EQ(ColorSpace::named("rec2020")->light(Rgb(0, 1, 0)).x, 0);
    // ACES has a white point of about 6000 K, warmer than D65. Reflectances are adapted to it.
    const Rgb white = ColorSpace::named("aces2065-1")->light(Rgb(1.f));
    EXPECT_GT(white.x, 1.02f);
    EXPECT_LT(white.z, 0.95f);
}

}  // namespace
}  // namespace drc::pbrt
